import { create } from "zustand";
import type { Program } from "../../nc/program.ts";
import { isSameData } from "../base/same.ts";

/** A document with a history of its own: a work, a table of the device, its settings. */
export type DocumentId = string;

/** A side of a history. */
export type Way = "past" | "future";

/** One step of undo. `back` and `forth` return whether they could be done: a step whose text is gone is skipped. */
export interface HistoryStep {
  /** The document that it changes. */
  readonly document: DocumentId;
  /**
   * Owner of the step, by identity: only steps of one owner join, and an owner that is replaced from outside loses its
   * steps.
   */
  readonly of: object;
  readonly back: () => boolean;
  readonly forth: () => boolean;
  /** The states before and after, if the step replaces whole states. */
  readonly states?: readonly [before: unknown, after: unknown];
  /** Key of the changed record, if a document has several. */
  readonly record?: string;
  /** Key of the changed file, if the text editor has the change. */
  readonly file?: string;
  /** The text of that file before and after the step, while it is the next one of this side. */
  readonly programs?: (way: Way) => readonly [before: Program, after: Program] | null;
  /** The steps that one action made. */
  readonly parts?: readonly HistoryStep[];
}

/** The changes of one document, oldest first; in `future` the next redo last. */
export interface History {
  readonly past: readonly HistoryStep[];
  readonly future: readonly HistoryStep[];
}

export interface Steps {
  /** By document, the one that changed last at the end. */
  readonly histories: ReadonlyMap<DocumentId, History>;
  /** The newest change; undo and redo do not alter it. */
  readonly newest: HistoryStep | null;
  /** Place of the last change while its step is open: typing on there belongs to that step. */
  readonly place: string | null;
}

/** Most steps of a document. Their states share unchanged parts, so this costs little. */
const MOST_STEPS = 1000;
/** Most documents with a history; the one that was changed longest ago is dropped. */
const MOST_DOCUMENTS = 16;

const EMPTY: History = { past: [], future: [] };

export const useSteps = create<Steps>(() => ({ histories: new Map(), newest: null, place: null }));

/** The history of a document; empty for none. */
export const historyOf = (document: DocumentId | null, { histories }: Steps = useSteps.getState()): History =>
  (document !== null && histories.get(document)) || EMPTY;

/** The step of a document that is undone next. */
export const lastStep = (document: DocumentId | null): HistoryStep | undefined => historyOf(document).past.at(-1);

/** Whether a step is the one that undo of its document takes back next. */
export const isLastStep = (step: HistoryStep | null | undefined, steps: Steps = useSteps.getState()): boolean =>
  step !== null && step !== undefined && historyOf(step.document, steps).past.at(-1) === step;

/** The same, followed. */
export const useIsLastStep = (step: HistoryStep | null | undefined): boolean => useSteps((s) => isLastStep(step, s));

/** Replaces a history; an empty one is removed. */
function put(document: DocumentId, history: History, more: Partial<Steps> = {}): void {
  const histories = new Map(useSteps.getState().histories);
  histories.delete(document);
  if (history.past.length > 0 || history.future.length > 0) histories.set(document, history);
  for (const [oldest] of histories) if (histories.size > MOST_DOCUMENTS) histories.delete(oldest);
  useSteps.setState({ ...more, histories });
}

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
  const { past, future } = historyOf(step.document);
  const last = past.at(-1);
  const joined = on && last?.of === step.of;
  const before = joined ? past.slice(0, -1) : past,
    next = joined ? joinedStep(last, step) : step;
  if (!isNoChange(next))
    return put(step.document, { past: [...before, next].slice(-MOST_STEPS), future: [] }, { newest: next });
  // The next change at this place must not join the step that is now last.
  closeStep();
  if (joined) put(step.document, { past: before, future });
}

/** The step between two states of a document, which `put` can restore. */
export const stepBetween = <S>(
  document: DocumentId,
  put: (state: S) => unknown,
  before: S,
  after: S,
  of: object = put,
): HistoryStep => ({
  document,
  of,
  back: () => put(before) !== false,
  forth: () => put(after) !== false,
  states: [before, after],
});

/** Restores the steps of the previous page, unless there are new ones. */
export function resumeSteps(document: DocumentId, history: History): void {
  if (historyOf(document) === EMPTY) put(document, history);
}

/** Removes the steps of an owner that was replaced from outside. */
export function forget(of: object): void {
  closeStep();
  for (const [document, { past, future }] of useSteps.getState().histories) {
    const kept = (steps: readonly HistoryStep[]) => steps.filter((step) => step.of !== of);
    put(document, { past: kept(past), future: kept(future) });
  }
}

/** Removes the history of a document. */
export function forgetDocument(document: DocumentId): void {
  closeStep();
  put(document, EMPTY);
}

/** Removes all histories. */
export const forgetAllSteps = (): void => useSteps.setState({ histories: new Map(), newest: null, place: null });

const OTHER = { past: "future", future: "past" } as const;
const ACTION = { past: "back", future: "forth" } as const;

/** Does the last step of one side and moves it to the other; a step that can no longer be done is dropped. */
function go(document: DocumentId, from: Way): void {
  closeStep();
  for (let step = historyOf(document)[from].at(-1); step; step = historyOf(document)[from].at(-1)) {
    const done = step[ACTION[from]]();
    const { [from]: side, [OTHER[from]]: other } = historyOf(document);
    const moved = { [from]: side.slice(0, -1), [OTHER[from]]: done ? [...other, step] : other };
    put(document, moved as unknown as History);
    if (done) return;
  }
}

/** Undoes the last change of a document that can be undone. */
export const undo = (document: DocumentId): void => go(document, "past");

/** Redoes the change of a document that was undone last. */
export const redo = (document: DocumentId): void => go(document, "future");

/** One step in place of all those of one action. */
function stepOfAction(made: readonly HistoryStep[], newest: HistoryStep): HistoryStep {
  if (made.every(({ of, states }) => states && of === newest.of)) return made.reduce(joinedStep);
  return {
    document: newest.document,
    of: newest.of,
    back: () =>
      made
        .toReversed()
        .map((step) => step.back())
        .includes(true),
    forth: () => made.map((step) => step.forth()).includes(true),
    parts: made,
  };
}

/** Joins the changes of one action that are stored in several places to one step of each document. */
export function asOneStep<T>(change: () => T): T {
  closeStep();
  const before = useSteps.getState().histories;
  const result = change();
  closeStep();
  for (const [document, { past, future }] of useSteps.getState().histories) {
    const last = before.get(document)?.past.at(-1);
    const begin = last === undefined ? 0 : past.lastIndexOf(last) + 1;
    const made = past.slice(begin),
      newest = made.at(-1);
    if (!newest || made.length === 1) continue;
    const joined = stepOfAction(made, newest);
    put(document, { past: [...past.slice(0, begin), joined], future }, { newest: joined });
  }
  return result;
}

/** Makes a change and returns the step that it became; null if it changed nothing. */
export function recorded(change: () => void): HistoryStep | null {
  const before = useSteps.getState().newest;
  change();
  const { newest } = useSteps.getState();
  return newest === before ? null : newest;
}
