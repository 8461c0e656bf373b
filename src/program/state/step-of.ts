import type { Spindle, Step } from "../../kernel/time/step.ts";
import { secondsOf, type RapidRate } from "../../kernel/time/time.ts";

/** A motion without its time, and its block. */
export type Motion = Omit<Step, "seconds" | "positionedBy">;

/** Consecutive motions, and their total time. */
export interface TimedSteps {
  readonly steps: readonly Step[];
  readonly seconds: number;
}

export const timed = (steps: readonly Step[]): TimedSteps => ({
  steps,
  seconds: steps.reduce((sum, step) => sum + step.seconds, 0),
});

const STILL: Spindle = { kind: "constant", speed: 0 };

/** A motion with the time that it takes. */
export function stepOf(
  { from, move, tool, block, operation, ...rare }: Motion,
  spindle: Spindle | null,
  rapid: RapidRate,
): Step {
  const seconds = secondsOf(from, move, spindle ?? STILL, rapid);
  // A literal with a spread has room for one more property, which few steps of a long path have.
  return Object.keys(rare).length === 0
    ? { from, move, tool, block, operation, seconds }
    : { from, move, tool, block, operation, seconds, ...rare };
}
