import type { HandedOn, Job } from "../../program/job/job.ts";
import { showNoWork, showWork } from "../place/place.ts";
import { closeStep, forget, continuesStep, recordStep, recordChange, stepBetween } from "./steps.ts";
import { createDeferredStore } from "../base/typing.ts";
import { isProgram, type ProgramWork, type Work } from "./work.ts";

/** The open work, and the key it is saved under on this device. */
export interface Editor {
  readonly job: Job | null;
  /** The open program; never together with a job. */
  readonly program: ProgramWork | null;
  /** Key of the saved work; null while there is none. */
  readonly work: string | null;
}

export const useEditor = createDeferredStore<Editor>(() => ({ job: null, program: null, work: null }));

/** Functions that flush buffered edits, called before another work is opened or the page goes away. */
export const pendingEdits = new Set<() => void>();

export function flushEdits(): void {
  for (const hand of pendingEdits) hand();
}

/** Sets the state of the open job; also the owner of its steps of undo. */
export const putJob = (job: Job): void => useEditor.setState({ job });
/** Opens a work, also by undo and redo: the work that changes is shown. */
const putWork = (state: Editor): void => {
  flushEdits();
  useEditor.setState(state);
  if (state.work === null) showNoWork();
  else showWork(state.program !== null);
};

/**
 * Changes the job as one step of undo. Successive changes at the same place are one step: a number is one step, however
 * many digits it has.
 */
export function edit(change: (job: Job) => Job, place: string | null = null): void {
  const { job } = useEditor.getState();
  if (!job) return;
  const next = change(job);
  if (next === job) return;
  putJob(next);
  recordChange(putJob, job, next, continuesStep(place));
}

/** Each work as it was last opened, for comparison with its present state. */
const opened = new Map<string, Work>();
export const openedVersion = (work: string): Work | null => opened.get(work) ?? null;

/** Replaces the open work, as one step of undo. */
export function open(content: Work | null, work: string | null): void {
  if (content && work !== null) opened.set(work, content);
  closeStep();
  flushEdits();
  const before = useEditor.getState();
  putWork(
    content && isProgram(content) ? { job: null, program: content, work } : { job: content, program: null, work },
  );
  recordChange(putWork, before, useEditor.getState());
}

/** Opens the first work: undo cannot go back behind it. */
export function openFirstWork(content: Work | null, work: string | null): void {
  open(content, work);
  forget();
}

/** Sets the open program after a change. The editor of the text records the steps. */
export const setProgram = (program: ProgramWork): void => useEditor.setState({ program });

/** Owner of the steps that change more of a program than one text. */
export const OF_FILES = {};

/** Restores a state of a program if that is still open. */
export const putProgram =
  (work: string | null) =>
  (program: ProgramWork): boolean => {
    if (useEditor.getState().work !== work) return false;
    flushEdits();
    setProgram(program);
    return true;
  };

/** Changes the open program as one step of undo; successive changes at the same place are one step. */
export function changeProgram(change: (program: ProgramWork) => ProgramWork, place: string | null = null): void {
  flushEdits();
  const { program: before, work } = useEditor.getState();
  const after = before && change(before);
  if (!after || after === before) return;
  const on = continuesStep(place);
  setProgram(after);
  recordStep(stepBetween(putProgram(work), before, after, OF_FILES), on);
}

/** The open work's own tools, control and machine, which replace those of the device; empty if none is open. */
export const bundleOf = ({ job, program }: Editor): HandedOn => job ?? program ?? {};

/** A work with another set of own tools, control and machine. */
export const withBundle = <W extends Job | ProgramWork>(work: W, next: HandedOn): W => {
  const { tools: _, control: __, machine: ___, ...bare } = work;
  return { ...bare, ...next } as unknown as W;
};

/** Changes the open work's own tools, control and machine as one step of undo. */
export function setBundle(next: HandedOn): void {
  if (useEditor.getState().program) changeProgram((program) => withBundle(program, next));
  else edit((job) => withBundle(job, next));
}
