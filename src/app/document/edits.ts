import type { Measurement } from "../../kernel/plan/measured.ts";
import type { ClampingDraft } from "../../program/clamping/words.ts";
import type { ContourRow, Job, SpindleDraft } from "../../program/job/job.ts";
import type { Draft } from "../../program/job/read-draft.ts";
import { change, changeJob, openContent, useEditor, type Editor } from "./store.ts";
import { LONGEST_REMARKS, MOST_MEASURED } from "./work.ts";

const noDraft: Draft = {};

/** The typed texts of the prompts of the job's cycle. */
export const draftOf = (job: Job): Draft => job.drafts[job.cycle] ?? noDraft;

/** The typed text of one prompt of the job. */
export function setPrompt(q: string, text: string): void {
  changeJob((job) => {
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
  changeJob((job) => ({
    ...job,
    drafts: { ...job.drafts, [job.cycle]: { ...draftOf(job), ...texts } },
    ...(blank && { blank: { ...job.blank, ...blank } }),
    ...(start && { start: { ...job.start, ...start } }),
  }));

/** The typed value of a Q parameter that prompts use. */
export const setParameter = (name: string, text: string): void =>
  changeJob((job) => ({ ...job, parameters: { ...job.parameters, [name]: text } }), `parameter ${name}`);

/** Sets the clamping of the job; null: not stated. */
export const setClamping = (clamping: ClampingDraft | null, place: string | null): void =>
  changeJob(({ clamping: _, ...job }) => ({ ...job, ...(clamping && { clamping }) }), place);

export const setSpindle = <F extends keyof SpindleDraft>(field: F, value: SpindleDraft[F]): void =>
  changeJob(
    (job) => ({ ...job, spindle: { ...job.spindle, [field]: value } }),
    field === "mode" ? null : `spindle ${field}`,
  );

export const setPerRevolution = (perRevolution: boolean): void => changeJob((job) => ({ ...job, perRevolution }));

export const setRapid = (rapid: string): void => changeJob((job) => ({ ...job, rapid }), "rapid");

export const setName = (name: string): void => changeJob((job) => ({ ...job, name }), "name");

export const setLayout = (layout: Job["layout"]): void => changeJob((job) => ({ ...job, layout }));

export const setNcLanguage = (ncLanguage: Job["ncLanguage"]): void => changeJob((job) => ({ ...job, ncLanguage }));

/** The contour table; `place` names the cell, so that typing in it is one step of undo. */
export const setContour = (contour: readonly ContourRow[], place: string | null = null): void =>
  changeJob((job) => ({ ...job, contour }), place && `contour ${place}`);

const NOTHING_MEASURED: readonly Measurement[] = [];

/** The measurements that a work keeps; the same list while nothing changes in it. */
export const measuredIn = (editor: Editor): readonly Measurement[] => openContent(editor)?.measured ?? NOTHING_MEASURED;

/** Changes the measurements as one step of undo; successive changes at the same place are one step. */
export function setMeasured(
  edit: (list: readonly Measurement[]) => readonly Measurement[],
  place: string | null = null,
): void {
  const list = edit(measuredIn(useEditor.getState())).slice(-MOST_MEASURED);
  change(({ measured: _, ...work }) => ({ ...work, ...(list.length > 0 && { measured: list }) }), place);
}

/** Sets the remarks of the setup sheet. */
export function setRemarks(text: string): void {
  const remarks = text.slice(0, LONGEST_REMARKS);
  change((work) => (work.remarks === remarks ? work : { ...work, remarks }), "remarks");
}

/** Sets the material of the open work. */
export const setMaterial = (material: string): void =>
  change((work) => (work.material === material ? work : { ...work, material }));
