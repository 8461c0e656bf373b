import { repeatedIn } from "../../cycles/acts-in.ts";
import type { Cycle } from "../../cycles/define.ts";
import type { Step } from "../../kernel/time/step.ts";

/** A numbered step of the manual and the piece of a run that shows it. */
export interface StepPiece {
  readonly run: "rough" | "finish";
  /** As the manual counts, from 1. */
  readonly number: number;
  /** Indices into the steps of the run, the last one not included; null where this run has nothing of it. */
  readonly piece: { readonly from: number; readonly to: number } | null;
}

type Numbered = Pick<Step, "move" | "operation">;

/** Index of the first step from `from` on that holds; the length where none does. */
function next(steps: readonly Numbered[], from: number, holds: (step: Numbered) => boolean): number {
  const found = steps.findIndex((step, i) => i >= from && holds(step));
  return found < 0 ? steps.length : found;
}

/**
 * The first time that each numbered step of a cycle runs in one of its calls, and for the step that repeats the others
 * all that comes between the first round and the next step.
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
