import { create } from "zustand";

/** A failed goal of an exercise: the number of its mark in the picture, what is wrong, and the way to its place. */
export interface TaskResultRow {
  readonly id: string;
  readonly mark: string;
  readonly kind: "finding" | "residual";
  readonly text: string;
  readonly go: () => void;
}

/** What an open exercise adds to findings and verdict. */
export interface TaskResult {
  /** The heading of the rows, and the failed goals of the last check. */
  readonly title: string;
  readonly rows: readonly TaskResultRow[];
  /** What the verdict verifies against: the cycle's own contour, not the part of the exercise; null without a part. */
  readonly against: string | null;
  /** Why no fix is offered yet; null where fixes are offered. */
  readonly heldBack: string | null;
}

/** Null if no exercise is open. */
export const useTaskResult = create<{ readonly result: TaskResult | null }>(() => ({ result: null }));

/** Whether an exercise asks for the fault and offers no fix yet. */
export const useFixesHeldBack = (): boolean => useTaskResult(({ result }) => (result?.heldBack ?? null) !== null);
