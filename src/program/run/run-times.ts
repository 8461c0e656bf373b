import { causeOf } from "../../kernel/time/time.ts";
import type { MachineTimed } from "../machine/machine-data.ts";
import { TIME_PARTS, type Run, type SecondsBeside, type TimePart, type Timing } from "../state/run-types.ts";

/** What a time of this shop contains, with what passed beside the motions. */
export function timingOf({ rapid, machine }: MachineTimed, beside: SecondsBeside): Timing {
  const stated: Readonly<Record<TimePart, boolean>> = {
    cutting: true,
    rapid: true,
    dwell: true,
    acceleration: machine?.acceleration !== undefined,
    toolChange: machine?.toolChange !== undefined,
    spindle: machine?.spindle?.runUp !== undefined,
  };
  return {
    beside,
    contains: TIME_PARTS.filter((part) => stated[part]),
    machine: machine?.name ?? null,
    turning: machine?.spindle ?? null,
    rates: machine?.rapid ?? rapid,
  };
}

/** Of a run that did nothing. */
export const NO_TIMING: Timing = timingOf({ rapid: 0 }, { toolChange: 0, spindle: 0, dwell: 0 });

/** The running time by what it passes for, s. */
export interface Times extends SecondsBeside {
  /** At a feed, threads included. */
  readonly cutting: number;
  readonly rapid: number;
  readonly total: number;
}

/** Where the time of a run goes. */
export function timesOf({
  steps,
  plane,
  seconds,
  timing: { beside },
}: Pick<Run, "steps" | "plane" | "seconds" | "timing">): Times {
  let [cutting, rapid, { dwell }] = [0, 0, beside];
  for (const { move, seconds: taken } of steps) {
    const cause = causeOf(move);
    if (cause === "rapid") rapid += taken;
    else if (cause === "dwell") dwell += taken;
    else cutting += taken;
  }
  for (const { feed, seconds: taken } of plane) {
    if (feed === undefined) rapid += taken;
    else cutting += taken;
  }
  return { cutting, rapid, ...beside, dwell, total: seconds };
}
