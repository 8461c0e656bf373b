import type { HandedOn, Job } from "../../program/job/job.ts";
import { showNoWork, showWork } from "../place/place.ts";
import { isSameData } from "../base/same.ts";
import { createDeferredStore } from "../base/typing.ts";
import { documentOfWork } from "./documents.ts";
import {
  closeStep,
  continuesStep,
  forgetDocument,
  recordStep,
  stepBetween,
  useSteps,
  type DocumentId,
  type HistoryStep,
} from "./steps.ts";
import { isProgram, kindOf, type ProgramWork, type Work } from "./work.ts";

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

/** The open work, as it is now. */
export const openContent = ({ job, program }: Editor = useEditor.getState()): Work | null => job ?? program;

/** The state with a work open, or none. */
const editorOf = (content: Work | null, work: string | null): Editor =>
  content && isProgram(content) ? { job: null, program: content, work } : { job: content, program: null, work };

/** Replaces the state of the open work. */
const put = (content: Work): void => useEditor.setState((now) => editorOf(content, now.work));

/** The document of the open work; null if none is open. */
export const openDocument = (editor: Editor = useEditor.getState()): DocumentId | null =>
  openContent(editor) && documentOfWork(editor.work);

/** Owner of the steps that replace a whole state of a work. */
const OF_STATE = {};

/** Restores a state of a work if that is open. */
const putState =
  (work: string | null) =>
  (state: Work): boolean => {
    if (useEditor.getState().work !== work) return false;
    flushEdits();
    put(state);
    return true;
  };

/** The step between two states of a work. */
export const workStep = (work: string | null, before: Work, after: Work): HistoryStep =>
  stepBetween(documentOfWork(work), putState(work), before, after, OF_STATE);

/**
 * Changes the open work as one step of undo. Successive changes at the same place are one step: a number is one step,
 * however many digits it has.
 */
export function change(edit: (content: Work) => Work, place: string | null = null): void {
  flushEdits();
  const before = openContent();
  const after = before && edit(before);
  if (!before || !after || after === before) return;
  const on = continuesStep(place);
  put(after);
  recordStep(workStep(useEditor.getState().work, before, after), on);
}

/** Changes the open work if it is a job. */
export const changeJob = (edit: (job: Job) => Job, place: string | null = null): void =>
  change((content) => (isProgram(content) ? content : edit(content)), place);

/** Changes the open work if it is a program. */
export const changeProgram = (edit: (program: ProgramWork) => ProgramWork, place: string | null = null): void =>
  change((content) => (isProgram(content) ? edit(content) : content), place);

/** Sets the open program after a change. The editor of the text records the steps. */
export const setProgram: (program: ProgramWork) => void = put;

/** Each work as it was last opened, for comparison with its present state. */
const opened = new Map<string, Work>();
export const openedVersion = (work: string): Work | null => opened.get(work) ?? null;

/** The last state here of each work with a history that was open before. */
const left = new Map<string, Work>();

/** Remembers the state in which the open work is left, to see on its return whether its history fits. */
function leave(): void {
  const before = useEditor.getState(),
    content = openContent(before);
  const { histories } = useSteps.getState();
  for (const [work] of left) if (!histories.has(documentOfWork(work))) left.delete(work);
  if (before.work !== null && content) left.set(before.work, content);
}

/** The state of a work that its history belongs to; null if it was not open here. */
export const knownState = (work: string | null): Work | null =>
  work === useEditor.getState().work ? openContent() : (left.get(work ?? "") ?? null);

/** Opens a work, or none. That is no step of undo; its history goes on if it has not changed elsewhere. */
export function open(content: Work | null, work: string | null): void {
  if (content && work !== null) opened.set(work, content);
  closeStep();
  flushEdits();
  leave();
  if (!isSameData(knownState(work), content)) forgetDocument(documentOfWork(work));
  useEditor.setState(editorOf(content, work));
  if (work === null || !content) showNoWork();
  else showWork(kindOf(content));
}

/** Opens a work without a history. */
export function openFirstWork(content: Work | null, work: string | null): void {
  open(content, work);
  forgetDocument(documentOfWork(work));
}

/** The open work's own tools, control and machine, which replace those of the device; empty if none is open. */
export const bundleOf = (editor: Editor): HandedOn => openContent(editor) ?? {};

/** A work with another set of own tools, control and machine. */
export const withBundle = ({ tools: _, control: __, machine: ___, ...bare }: Work, next: HandedOn): Work => ({
  ...bare,
  ...next,
});

/** Changes the open work's own tools, control and machine as one step of undo. */
export const setBundle = (next: HandedOn): void => change((content) => withBundle(content, next));
