import { create } from "zustand";
import { isSameData } from "../base/same.ts";

/** One step of undo. `back` and `forth` return whether they could be done: a step whose text is gone is skipped. */
export interface HistoryStep {
  /**
   * Owner of the step, by identity: only steps of one owner join, and an owner that is replaced from outside loses its
   * steps.
   */
  readonly of: object;
  readonly back: () => boolean;
  readonly forth: () => boolean;
  /** The states before and after, if the step replaces whole states. */
  readonly states?: readonly [before: unknown, after: unknown];
  /** Key of the changed file, if the text editor has the change. */
  readonly file?: string;
}

/**
 * The history of the page: prompts, contours, set-ups, program text, tools and the open work, in the order of the
 * changes.
 */
export interface Steps {
  readonly past: readonly HistoryStep[];
  readonly future: readonly HistoryStep[];
  /** Place of the last change while its step is open: typing on there belongs to that step. */
  readonly place: string | null;
}

/** A side of the history. */
export type Way = "past" | "future";

/** Most steps that undo keeps. Their states share unchanged parts, so this costs little. */
const LIMIT = 1000;

export const useSteps = create<Steps>(() => ({ past: [], future: [], place: null }));

/**
 * Closes the last step: the next change starts a new one. Called when a field loses the focus, or after a key with an
 * action.
 */
export const closeStep = (): void => useSteps.setState({ place: null });

/** Whether a change at this place continues the last step. The place is remembered for the next change. */
export function continuesStep(place: string | null): boolean {
  const on = place !== null && place === useSteps.getState().place;
  useSteps.setState({ place });
  return on;
}

/** One step in place of two successive ones. */
const joinedStep = (first: HistoryStep, second: HistoryStep): HistoryStep => ({
  ...second,
  back: first.back,
  ...(first.states && second.states && { states: [first.states[0], second.states[1]] as const }),
});

/** True for a step without a change, such as a digit typed and erased: undoing it would be invisible. */
const isNoChange = ({ states }: HistoryStep): boolean => states !== undefined && isSameData(...states);

/** Records a change that was just made. `on`: it continues the last step. */
export function recordStep(step: HistoryStep, on = false): void {
  const { past } = useSteps.getState();
  const last = past.at(-1);
  const joined = on && last?.of === step.of;
  const before = joined ? past.slice(0, -1) : past,
    next = joined ? joinedStep(last, step) : step;
  if (!isNoChange(next)) return useSteps.setState({ past: [...before, next].slice(-LIMIT), future: [] });
  // The next change at this place must not join the step that is now last.
  closeStep();
  if (joined) useSteps.setState({ past: before });
}

/** The step between two states, which `put` can restore. */
export const stepBetween = <S>(put: (state: S) => unknown, before: S, after: S, of: object = put): HistoryStep => ({
  of,
  back: () => put(before) !== false,
  forth: () => put(after) !== false,
  states: [before, after],
});

/** Restores the steps of the previous page, unless there are new ones. */
export function resumeSteps(past: readonly HistoryStep[], future: readonly HistoryStep[]): void {
  const now = useSteps.getState();
  if (now.past.length === 0 && now.future.length === 0) useSteps.setState({ past, future });
}

/** Records that a state was replaced; `put` restores either state, and is the owner of the step. */
export const recordChange = <S>(put: (state: S) => void, before: S, after: S, on = false): void =>
  recordStep(stepBetween(put, before, after), on);

/** Removes the steps of an owner that was replaced from outside, or all steps. */
export function forget(of: object | null = null): void {
  closeStep();
  const kept = (steps: readonly HistoryStep[]) => (of === null ? [] : steps.filter((step) => step.of !== of));
  useSteps.setState(({ past, future }) => ({ past: kept(past), future: kept(future) }));
}

/** Does the last step of one side and moves it to the other; a step that can no longer be done is dropped. */
function go(from: Way, to: Way, way: "back" | "forth"): void {
  closeStep();
  for (let step = useSteps.getState()[from].at(-1); step; step = useSteps.getState()[from].at(-1)) {
    const gone = step;
    const done = gone[way]();
    useSteps.setState((s) => ({ ...s, [from]: s[from].slice(0, -1), [to]: done ? [...s[to], gone] : s[to] }));
    if (done) return;
  }
}

/** Undoes the last change that can be undone. */
export const undo = (): void => go("past", "future", "back");

/** Redoes the change that was undone last. */
export const redo = (): void => go("future", "past", "forth");

/** Joins the changes of one action that are stored in several places to one step. */
export function asOneStep<T>(change: () => T): T {
  closeStep();
  const last = useSteps.getState().past.at(-1);
  const result = change();
  closeStep();
  const { past } = useSteps.getState(),
    begin = last === undefined ? 0 : past.lastIndexOf(last) + 1;
  const made = past.slice(begin),
    newest = made.at(-1);
  if (!newest || made.length === 1) return result;
  const joined: HistoryStep = {
    of: newest.of,
    back: () =>
      made
        .toReversed()
        .map((step) => step.back())
        .includes(true),
    forth: () => made.map((step) => step.forth()).includes(true),
  };
  useSteps.setState({ past: [...past.slice(0, begin), joined] });
  return result;
}
