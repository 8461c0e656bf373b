import type { AxisWord } from "../../nc/words.ts";
import { programIssue } from "../state/issue.ts";
import type { Machine } from "../state/machine.ts";

/** Name of an off-centre cut in the unverified list. */
const BESIDE = "Y";

/**
 * A word of an axis outside the turning plane: Y moves the tool off centre or back, others leave the rest unverified.
 */
export function otherAxisWord(machine: Machine, { axis, incremental }: AxisWord, n: number, index: number): void {
  if (axis === "Y" && machine.now.turning) {
    const { offsetY, datum } = machine.now;
    const by = machine.length(n);
    machine.set({ offsetY: incremental ? (offsetY ?? datum.y) + by : by + datum.y });
  } else if (n !== 0) machine.log.leaveUnproved(`${incremental ? "I" : ""}${axis}`, index);
}

/** An off-centre cut is not in the simulated plane. Without a Y word the tool is at the datum in Y. */
export function offCentre(machine: Machine, index: number): void {
  const { turning, offsetY, datum, unknownDatum } = machine.now;
  const y = offsetY ?? datum.y;
  if (!turning || y === 0 || (offsetY === null && unknownDatum.includes("y"))) return;
  // Everything after the first such cut is unverified already.
  if (machine.log.unproved.slice().some(({ what }) => what === BESIDE)) return;
  machine.log.report(programIssue("offCentre", "warning", { y }), index);
  machine.log.leaveUnproved(BESIDE, index);
}
