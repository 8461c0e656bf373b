import { causeOf } from "../../kernel/time/time.ts";
import type { MachineTimed } from "../machine/machine-data.ts";
import { TIME_PARTS, type Run, type NonMotionSeconds, type TimePart, type Timing } from "../state/run-types.ts";

/** Data behind the times of a shop, with the seconds outside of motions. */
export function timingOf({ rapid, machine }: MachineTimed, beside: NonMotionSeconds): Timing {
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

/** Timing of an empty run. */
export const NO_TIMING: Timing = timingOf({ rapid: 0 }, { toolChange: 0, spindle: 0, dwell: 0 });

/** Running time by cause, s. */
export interface Times extends NonMotionSeconds {
  /** At a feed, threads included. */
  readonly cutting: number;
  readonly rapid: number;
  readonly total: number;
}

/** Splits the time of a run by cause. */
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
