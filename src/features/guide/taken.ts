import { create } from "zustand";
import { useSteps, type HistoryStep } from "../../app/document/steps.ts";

/** A value that was taken over into the work from a page of the guide, and the step of undo that it became. */
export interface TakenValue {
  /** What it is, as it is written in front of the value: Q463, VC, LEN. */
  readonly letter: string;
  /** As it is written; a number in the writing of the screen language. */
  readonly value: number | string;
  readonly step: HistoryStep | null;
}

const useNewest = create<{ readonly taken: TakenValue | null }>(() => ({ taken: null }));

/** Makes a change that takes a value over, and tells of it where it became a step. */
export function takeOver(letter: string, value: number | string, change: () => void): void {
  const before = useSteps.getState().past.at(-1);
  change();
  const step = useSteps.getState().past.at(-1);
  useNewest.setState({ taken: step === undefined || step === before ? null : { letter, value, step } });
}

/** Another page is shown: nothing has been taken over on it yet. */
export const forgetTaken = (): void => useNewest.setState({ taken: null });

/** What was taken over last, as long as that is the last change. */
export function useTaken(): TakenValue | null {
  const taken = useNewest((s) => s.taken);
  const isLast = useSteps((s) => s.past.at(-1) === taken?.step);
  return isLast ? taken : null;
}
