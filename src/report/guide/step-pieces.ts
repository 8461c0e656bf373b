import { repeatedIn } from "../../cycles/active-steps.ts";
import type { Cycle } from "../../cycles/define.ts";
import type { Step } from "../../kernel/time/step.ts";

/** A numbered step of the manual with the stretch of a run that shows it. */
export interface StepPiece {
  readonly run: "rough" | "finish";
  /** As the manual counts, from 1. */
  readonly number: number;
  /** Step indices of the run, end exclusive; null where the run does not contain it. */
  readonly piece: { readonly from: number; readonly to: number } | null;
}

type Numbered = Pick<Step, "move" | "operation">;

/** Index of the first matching step from `from` on; the length without one. */
function next(steps: readonly Numbered[], from: number, holds: (step: Numbered) => boolean): number {
  const found = steps.findIndex((step, i) => i >= from && holds(step));
  return found < 0 ? steps.length : found;
}

/**
 * The first occurrence of each numbered step in one call of a cycle. For the step that repeats the others, everything
 * between the first round and the next step.
 */
export function stepPieces(
  cycle: Pick<Cycle, "group" | "steps">,
  steps: readonly Numbered[],
  operation: number,
): readonly StepPiece[] {
  const isOf =
    (run: StepPiece["run"], number: number) =>
    ({ move, operation: of }: Numbered) =>
      of === operation && move.run === run && move.step === number;
  const firstOf = (run: StepPiece["run"], number: number): StepPiece["piece"] => {
    const is = isOf(run, number),
      from = next(steps, 0, is);
    return from === steps.length ? null : { from, to: next(steps, from, (step) => !is(step)) };
  };
  const repeated = (number: number): StepPiece["piece"] => {
    const before = Array.from({ length: number - 1 }, (_, i) => firstOf("rough", number - 1 - i)).find(
      (piece) => piece !== null,
    );
    if (!before) return null;
    const isEnd = ({ move, operation: of }: Numbered) =>
      of !== operation || move.run === "finish" || move.step > number;
    const to = next(steps, before.to, isEnd);
    return to > before.to ? { from: before.to, to } : null;
  };
  const pieceOf = (run: StepPiece["run"], number: number) =>
    run === "rough" && number === repeatedIn(cycle) ? repeated(number) : firstOf(run, number);
  return (["rough", "finish"] as const).flatMap((run) =>
    Array.from({ length: cycle.steps[run] }, (_, i): StepPiece => ({ run, number: i + 1, piece: pieceOf(run, i + 1) })),
  );
}
