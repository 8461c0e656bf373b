import { temporal } from "zundo";
import { create } from "zustand";
import type { Job } from "../program/job.ts";

/** What undo and redo go through: the work, and the name it is kept under on this device. */
export interface Editor {
  readonly job: Job | null;
  /** Key of the saved work; null while there is none. */
  readonly work: string | null;
}

/** Steps that undo keeps. Jobs share their unchanged parts, so this costs little. */
const HISTORY = 500;

export const useEditor = create<Editor>()(
  temporal((): Editor => ({ job: null, work: null }), {
    limit: HISTORY,
    equality: (past, now) => past.job === now.job && past.work === now.work,
  }),
);

/** What was changed last; typing on in the same place belongs to the same step of undo. */
let lastPlace: string | null = null;

/** The next change begins its own step of undo: a field was left, a key of its own was pressed. */
export const closeStep = (): void => {
  lastPlace = null;
};

/**
 * Changes the job as one step of undo. Changes that name the same place, one after the other, are one step together:
 * a number is typed in one step, however many digits it has.
 */
export function edit(change: (job: Job) => Job, place: string | null = null): void {
  const { job } = useEditor.getState();
  if (!job) return;
  const next = change(job);
  if (next === job) return;
  const history = useEditor.temporal.getState();
  const goesOn = place !== null && place === lastPlace;
  if (goesOn) history.pause();
  useEditor.setState({ job: next });
  if (goesOn) history.resume();
  lastPlace = place;
}

/** Puts other work in place of this one, as one step of undo. */
export function open(job: Job | null, work: string | null): void {
  closeStep();
  useEditor.setState({ job, work });
}

/** Puts the first work in place: there is nothing before it that undo could go back to. */
export function begin(job: Job | null, work: string | null): void {
  open(job, work);
  useEditor.temporal.getState().clear();
}

export function undo(): void {
  closeStep();
  useEditor.temporal.getState().undo();
}

export function redo(): void {
  closeStep();
  useEditor.temporal.getState().redo();
}
