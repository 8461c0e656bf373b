import { create } from "zustand";
import { isSameData } from "../base/same.ts";

/**
 * One step of undo. Both ways say whether they could be gone: a step whose text is no longer held is passed over.
 */
export interface HistoryStep {
  /**
   * What the step changes, by identity: only steps of the same thing join, and what is replaced from outside takes its
   * steps along.
   */
  readonly of: object;
  readonly back: () => boolean;
  readonly forth: () => boolean;
  /** The states that it leads back and forth to, where it puts whole ones in place. */
  readonly states?: readonly [before: unknown, after: unknown];
  /** Key of the file whose text it goes through, where the text editor holds what changed. */
  readonly file?: string;
}

/**
 * The one history of the page: prompts, contours, set-ups, program text, tools and which work is open, in the order
 * they were changed.
 */
export interface Steps {
  readonly past: readonly HistoryStep[];
  readonly future: readonly HistoryStep[];
  /** What was changed last, while its step is open: typing on in the same place belongs to it. */
  readonly place: string | null;
}

/** A side of the history. */
export type Way = "past" | "future";

/** Steps that undo keeps. Their states share what did not change, so this costs little. */
const LIMIT = 1000;

export const useSteps = create<Steps>(() => ({ past: [], future: [], place: null }));

/** The next change begins its own step: a field was left, a key of its own was pressed. */
export const closeStep = (): void => useSteps.setState({ place: null });

/**
 * True when a change at this place goes on with the step of the change before; the next one is asked about this place.
 */
export function goesOn(place: string | null): boolean {
  const on = place !== null && place === useSteps.getState().place;
  useSteps.setState({ place });
  return on;
}

/** One step in place of two that follow each other. */
const joinedStep = (first: HistoryStep, second: HistoryStep): HistoryStep => ({
  ...second,
  back: first.back,
  ...(first.states && second.states && { states: [first.states[0], second.states[1]] as const }),
});

/** A drag that is taken back, a digit that is typed and erased: nobody would see that such a step is undone. */
const leadsNowhere = ({ states }: HistoryStep): boolean => states !== undefined && isSameData(...states);

/** Notes a change that was just made. `on`: it goes on with the step before, which then leads here at once. */
export function note(step: HistoryStep, on = false): void {
  const { past } = useSteps.getState();
  const last = past.at(-1);
  const joined = on && last?.of === step.of;
  const before = joined ? past.slice(0, -1) : past,
    next = joined ? joinedStep(last, step) : step;
  if (!leadsNowhere(next)) return useSteps.setState({ past: [...before, next].slice(-LIMIT), future: [] });
  // What comes next at this place is no part of the step that is the last one now.
  closeStep();
  if (joined) useSteps.setState({ past: before });
}

/** The step between two states, either of which `put` puts in place. */
export const stepBetween = <S>(put: (state: S) => unknown, before: S, after: S, of: object = put): HistoryStep => ({
  of,
  back: () => put(before) !== false,
  forth: () => put(after) !== false,
  states: [before, after],
});

/** Puts steps in place that outlasted the page before, where none were made since. */
export function resumeSteps(past: readonly HistoryStep[], future: readonly HistoryStep[]): void {
  const now = useSteps.getState();
  if (now.past.length === 0 && now.future.length === 0) useSteps.setState({ past, future });
}

/** Notes that a state was replaced; `put` puts either of the two in place, and is what the step is of. */
export const noteChange = <S>(put: (state: S) => void, before: S, after: S, on = false): void =>
  note(stepBetween(put, before, after), on);

/** Lets go the steps of a thing that was replaced from outside, or all of them. */
export function forget(of: object | null = null): void {
  closeStep();
  const kept = (steps: readonly HistoryStep[]) => (of === null ? [] : steps.filter((step) => step.of !== of));
  useSteps.setState(({ past, future }) => ({ past: kept(past), future: kept(future) }));
}

/** Goes the last step of one side and puts it on the other; what can not be gone any more falls out. */
function go(from: Way, to: Way, way: "back" | "forth"): void {
  closeStep();
  for (let step = useSteps.getState()[from].at(-1); step; step = useSteps.getState()[from].at(-1)) {
    const gone = step;
    const done = gone[way]();
    useSteps.setState((s) => ({ ...s, [from]: s[from].slice(0, -1), [to]: done ? [...s[to], gone] : s[to] }));
    if (done) return;
  }
}

/** Takes back the last change that can be taken back. */
export const undo = (): void => go("past", "future", "back");

/** Makes the change again that was taken back last. */
export const redo = (): void => go("future", "past", "forth");

/** What is one change to the operator and is kept in several places becomes one step. */
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
