import type { Measurement } from "../../kernel/plan/measured.ts";
import type { ClampingDraft } from "../../program/clamping/words.ts";
import type { ContourRow, Job, SpindleDraft } from "../../program/job/job.ts";
import type { Draft } from "../../program/job/read-draft.ts";
import { changeProgram, edit, useEditor, type Editor } from "./store.ts";
import { LONGEST_REMARKS, MOST_MEASURED, type ProgramWork } from "./work.ts";

const noDraft: Draft = {};

/** The typed texts of the prompts of the job's cycle. */
export const draftOf = (job: Job): Draft => job.drafts[job.cycle] ?? noDraft;

/** The typed text of one prompt of the job. */
export function setPrompt(q: string, text: string): void {
  edit((job) => {
    const draft = draftOf(job);
    return draft[q] === text ? job : { ...job, drafts: { ...job.drafts, [job.cycle]: { ...draft, [q]: text } } };
  }, `prompt ${q}`);
}

/** Sizes of the set-up that belong to prompts; an empty text restores the proposal. */
export interface SetupSizes {
  readonly blank?: Partial<Job["blank"]>;
  readonly start?: Partial<Job["start"]>;
}

/** The typed texts of several prompts of the job, and sizes of its set-up, in one step. */
export const setPrompts = (texts: Draft, { blank, start }: SetupSizes = {}): void =>
  edit((job) => ({
    ...job,
    drafts: { ...job.drafts, [job.cycle]: { ...draftOf(job), ...texts } },
    ...(blank && { blank: { ...job.blank, ...blank } }),
    ...(start && { start: { ...job.start, ...start } }),
  }));

/** The typed value of a Q parameter that prompts use. */
export const setParameter = (name: string, text: string): void =>
  edit((job) => ({ ...job, parameters: { ...job.parameters, [name]: text } }), `parameter ${name}`);

/** Sets the clamping of the job; null: not stated. */
export const setClamping = (clamping: ClampingDraft | null, place: string | null): void =>
  edit(({ clamping: _, ...job }) => ({ ...job, ...(clamping && { clamping }) }), place);

export const setSpindle = <F extends keyof SpindleDraft>(field: F, value: SpindleDraft[F]): void =>
  edit(
    (job) => ({ ...job, spindle: { ...job.spindle, [field]: value } }),
    field === "mode" ? null : `spindle ${field}`,
  );

export const setPerRevolution = (perRevolution: boolean): void => edit((job) => ({ ...job, perRevolution }));

export const setRapid = (rapid: string): void => edit((job) => ({ ...job, rapid }), "rapid");

export const setName = (name: string): void => edit((job) => ({ ...job, name }), "name");

export const setLayout = (layout: Job["layout"]): void => edit((job) => ({ ...job, layout }));

export const setNcLanguage = (ncLanguage: Job["ncLanguage"]): void => edit((job) => ({ ...job, ncLanguage }));

/** The contour table; `place` names the cell, so that typing in it is one step of undo. */
export const setContour = (contour: readonly ContourRow[], place: string | null = null): void =>
  edit((job) => ({ ...job, contour }), place && `contour ${place}`);

const NOTHING_MEASURED: readonly Measurement[] = [];

/** The measurements that a work keeps; the same list while nothing changes in it. */
export const measuredIn = ({ job, program }: Editor): readonly Measurement[] =>
  (job ?? program)?.measured ?? NOTHING_MEASURED;

/** Changes the measurements as one step of undo; successive changes at the same place are one step. */
export function setMeasured(
  change: (list: readonly Measurement[]) => readonly Measurement[],
  place: string | null = null,
): void {
  const list = change(measuredIn(useEditor.getState())).slice(-MOST_MEASURED);
  const put = <W extends Job | ProgramWork>({ measured: _, ...work }: W): W =>
    ({ ...work, ...(list.length > 0 && { measured: list }) }) as unknown as W;
  if (useEditor.getState().program) changeProgram(put, place);
  else edit(put, place);
}

/** Sets the remarks of the setup sheet. */
export function setRemarks(text: string): void {
  const remarks = text.slice(0, LONGEST_REMARKS);
  const put = <W extends { readonly remarks?: string }>(work: W): W =>
    work.remarks === remarks ? work : { ...work, remarks };
  if (useEditor.getState().program) changeProgram(put, "remarks");
  else edit(put, "remarks");
}

/** Sets the material of the open work. */
export function setMaterial(material: string): void {
  const put = <W extends { readonly material?: string }>(work: W): W =>
    work.material === material ? work : { ...work, material };
  if (useEditor.getState().program) changeProgram(put);
  else edit(put);
}
