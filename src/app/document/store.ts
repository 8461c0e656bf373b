import type { HandedOn, Job } from "../../program/job/job.ts";
import { showNoWork, showWork } from "../place/place.ts";
import { closeStep, forget, goesOn, note, noteChange, stepBetween } from "./steps.ts";
import { heldWhileTyping } from "../base/typing.ts";
import { isProgram, type ProgramWork, type Work } from "./work.ts";

/** What is worked on, and the name it is kept under on this device. */
export interface Editor {
  readonly job: Job | null;
  /** The open program; never together with a job. */
  readonly program: ProgramWork | null;
  /** Key of the saved work; null while there is none. */
  readonly work: string | null;
}

export const useEditor = heldWhileTyping<Editor>(() => ({ job: null, program: null, work: null }));

/**
 * What hands over changes that it still holds back: asked before the work is changed for another one, or the page goes
 * away.
 */
export const beforeLeaving = new Set<() => void>();

export function handOver(): void {
  for (const hand of beforeLeaving) hand();
}

/** Puts a state of the open job in place; what its steps are steps of. */
export const putJob = (job: Job): void => useEditor.setState({ job });
/** Opening a work, its undo and its redo all come through here: what they change is what is seen. */
const putWork = (state: Editor): void => {
  handOver();
  useEditor.setState(state);
  if (state.work === null) showNoWork();
  else showWork(state.program !== null);
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
  putJob(next);
  noteChange(putJob, job, next, goesOn(place));
}

/** Each work as it was when it was last opened, for comparing it with what became of it. */
const opened = new Map<string, Work>();
export const asOpened = (work: string): Work | null => opened.get(work) ?? null;

/** Puts other work in place of this one, as one step of undo. */
export function open(content: Work | null, work: string | null): void {
  if (content && work !== null) opened.set(work, content);
  closeStep();
  handOver();
  const before = useEditor.getState();
  putWork(
    content && isProgram(content) ? { job: null, program: content, work } : { job: content, program: null, work },
  );
  noteChange(putWork, before, useEditor.getState());
}

/** Puts the first work in place: there is nothing before it that undo could go back to. */
export function begin(content: Work | null, work: string | null): void {
  open(content, work);
  forget();
}

/** The text of the open program after a change. Its steps are noted where it is typed. */
export const setProgram = (program: ProgramWork): void => useEditor.setState({ program });

/** What steps that change more of a program than a text are steps of. */
export const OF_FILES = {};

/** Puts a state of a program in place, as long as it is open. */
export const putProgram =
  (work: string | null) =>
  (program: ProgramWork): boolean => {
    if (useEditor.getState().work !== work) return false;
    handOver();
    setProgram(program);
    return true;
  };

/**
 * Changes what belongs to the open program, as one step of undo; changes at the same place, one after the other, are
 * one step together.
 */
export function changeProgram(change: (program: ProgramWork) => ProgramWork, place: string | null = null): void {
  handOver();
  const { program: before, work } = useEditor.getState();
  const after = before && change(before);
  if (!after || after === before) return;
  const on = goesOn(place);
  setProgram(after);
  note(stepBetween(putProgram(work), before, after, OF_FILES), on);
}

/** What the open work brings along in place of what the device has; nothing where none is open. */
export const handedOn = ({ job, program }: Editor): HandedOn => job ?? program ?? {};

/** A work with something else that it brings along. */
export const withHandedOn = <W extends Job | ProgramWork>(work: W, next: HandedOn): W => {
  const { tools: _, control: __, machine: ___, ...bare } = work;
  return { ...bare, ...next } as unknown as W;
};

/** Changes what the open work brings along, as one step of undo. */
export function setHandedOn(next: HandedOn): void {
  if (useEditor.getState().program) changeProgram((program) => withHandedOn(program, next));
  else edit((job) => withHandedOn(job, next));
}
