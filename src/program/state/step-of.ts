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
export const stepOf = (
  { from, move, tool, block, operation, ...line }: Motion,
  spindle: Spindle | null,
  rapid: RapidRate,
): Step => ({
  from,
  move,
  tool,
  block,
  operation,
  seconds: secondsOf(from, move, spindle ?? STILL, rapid),
  ...line,
});
