import { temporal } from "zundo";
import { create } from "zustand";
import type { Job } from "../program/job.ts";
import { isProgram, type ProgramWork, type Work } from "./work.ts";

/** What undo and redo go through: the work, and the name it is kept under on this device. */
export interface Editor {
  readonly job: Job | null;
  /** The open program; never together with a job. */
  readonly program: ProgramWork | null;
  /** Key of the saved work; null while there is none. */
  readonly work: string | null;
}

/** Steps that undo keeps. Jobs share their unchanged parts, so this costs little. */
const HISTORY = 500;

export const useEditor = create<Editor>()(temporal((): Editor => ({ job: null, program: null, work: null }), {
  limit: HISTORY,
  equality: (past, now) => past.job === now.job && past.program === now.program && past.work === now.work,
}));

/** What was changed last; typing on in the same place belongs to the same step of undo. */
let lastPlace: string | null = null;

/** The next change begins its own step of undo: a field was left, a key of its own was pressed. */
export const closeStep = (): void => {
  lastPlace = null;
};

/** True when a change at this place goes on with the step of the change before; the next one is asked about this place. */
export function goesOn(place: string | null): boolean {
  const on = place !== null && place === lastPlace;
  lastPlace = place;
  return on;
}

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
  const on = goesOn(place);
  if (on) history.pause();
  useEditor.setState({ job: next });
  if (on) history.resume();
}

/** Puts other work in place of this one, as one step of undo. */
export function open(content: Work | null, work: string | null): void {
  closeStep();
  useEditor.setState(content && isProgram(content) ? { job: null, program: content, work } : { job: content, program: null, work });
}

/** Puts the first work in place: there is nothing before it that undo could go back to. */
export function begin(content: Work | null, work: string | null): void {
  open(content, work);
  useEditor.temporal.getState().clear();
}

/** The text of the open program after a change. Its own history holds the steps, so this is none. */
export function setProgram(program: ProgramWork): void {
  const history = useEditor.temporal.getState();
  history.pause();
  useEditor.setState({ program });
  history.resume();
}

export function undo(): void {
  closeStep();
  useEditor.temporal.getState().undo();
}

export function redo(): void {
  closeStep();
  useEditor.temporal.getState().redo();
}
