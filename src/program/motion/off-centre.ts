import type { AxisWord } from "../../nc/words.ts";
import { programIssue } from "../state/issue.ts";
import type { Machine } from "../state/machine.ts";

/** How a cut beside the centre is called among what is not proved. */
const BESIDE = "Y";

/**
 * A word of an axis that no path of turning runs along: Y takes the tool off the centre or back, others leave nothing
 * proved.
 */
export function namedAside(machine: Machine, { axis, incremental }: AxisWord, n: number, index: number): void {
  if (axis === "Y" && machine.now.turning) {
    const { besideCentre, datum } = machine.now;
    const by = machine.length(n);
    machine.set({ besideCentre: incremental ? (besideCentre ?? datum.y) + by : by + datum.y });
  } else if (n !== 0) machine.log.leaveUnproved(`${incremental ? "I" : ""}${axis}`, index);
}

/**
 * A cut beside the centre of the spindle is not in the plane that is simulated. Without a Y word the tool stands where
 * Y counts from.
 */
export function offCentre(machine: Machine, index: number): void {
  const { turning, besideCentre, datum, unknownDatum } = machine.now;
  const y = besideCentre ?? datum.y;
  if (!turning || y === 0 || (besideCentre === null && unknownDatum.includes("y"))) return;
  // From the first such cut on nothing is proved, whatever comes.
  if (machine.log.unproved.slice().some(({ what }) => what === BESIDE)) return;
  machine.log.say(programIssue("offCentre", "warning", { y }), index);
  machine.log.leaveUnproved(BESIDE, index);
}
