import { create } from "zustand";
import { recorded, useIsLastStep, type HistoryStep } from "../../app/document/steps.ts";

/** A value applied to the work from a page of the guide, and its step of undo. */
export interface AppliedValue {
  /** Label in front of the value: Q463, VC, LEN. */
  readonly letter: string;
  /** The value as written; a number in the format of the screen language. */
  readonly value: number | string;
  readonly step: HistoryStep;
}

const useNewest = create<{ readonly taken: AppliedValue | null }>(() => ({ taken: null }));

/** Makes a change that applies a value, and notes it if it became a step. */
export function applyAndReport(letter: string, value: number | string, change: () => void): void {
  const step = recorded(change);
  useNewest.setState({ taken: step && { letter, value, step } });
}

/** Clears the note for another page. */
export const clearAppliedValue = (): void => useNewest.setState({ taken: null });

/** The last applied value, as long as it is the last change. */
export function useAppliedValue(): AppliedValue | null {
  const taken = useNewest((s) => s.taken);
  const isLast = useIsLastStep(taken?.step);
  return isLast ? taken : null;
}
