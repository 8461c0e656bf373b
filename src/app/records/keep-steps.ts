import { jsonOf, storedText } from "../base/storage.ts";
import { undoneRecords } from "../base/record.ts";
import { flushEdits, OF_FILES, putJob, putProgram, useEditor } from "../document/store.ts";
import { resumeSteps, stepBetween, useSteps, type HistoryStep } from "../document/steps.ts";
import type { Work } from "../document/work.ts";
import { withDifference, differenceOf, fingerprint, type Difference, type Json } from "./difference.ts";

/*
 * The undo history of the open work, the tools and the own cycles survives a reload. It is written when the page
 * closes, so that typing never waits for it, and used only for the same state.
 */

const KEPT = storedText("steps", "tab");

/** Most steps in one direction, and characters in total. */
const MOST = { steps: 200, size: 2_000_000 };

/** A program text as the editor saves it, with history and cursor. */
export interface KeptText {
  readonly file: string;
  readonly state: unknown;
}

/** Record whose steps are mixed with those of a work (tools, own cycles), by its key. */
const recordOf = (of: object | string | undefined) => undoneRecords().find(({ key, put }) => key === of || put === of);
/** Known states while the steps are walked, as JSON. */
type Known = Partial<Record<string, Json>>;
const WORK = "work";
const knownNow = (present: Work | null) =>
  Object.fromEntries([[WORK, present], ...undoneRecords().map(({ key, now }) => [key, now()])]) as Known;

/** A step: the difference of a whole state from the known one, or one step in the text of a file. */
type KeptStep =
  { readonly near: Difference; readonly far: Difference; readonly table?: string } | { readonly file: string };

interface KeptSteps {
  /** Empty if no work was open. */
  readonly work: string;
  readonly print: string;
  /** Fingerprints of the tables; their steps apply only to the same tables. */
  readonly tables?: Readonly<Record<string, string>>;
  /** Newest change first; in `future` the next redo first. */
  readonly past: readonly KeptStep[];
  readonly future: readonly KeptStep[];
  readonly texts: readonly KeptText[];
}

/** Called for the texts of a work when the page closes. */
export const textKeepers = new Set<(work: string) => readonly KeptText[]>();

/** Steps of the open work and the tables, from the present states outwards, up to the first larger step. */
function kept(steps: readonly HistoryStep[], present: Work | null, nearSide: 0 | 1): readonly KeptStep[] {
  const found: KeptStep[] = [];
  const known = knownNow(present);
  let size = 0;
  for (const step of [...steps].reverse()) {
    const table = recordOf(step.of)?.key;
    const isWhole = present !== null && (step.of === putJob || step.of === OF_FILES);
    // Steps end where another work was opened.
    if (step.file === undefined && !((isWhole || table) && step.states)) break;
    if (step.file !== undefined) found.push({ file: step.file });
    else if (step.states) {
      const of = table ?? WORK;
      const near = step.states[nearSide] as Json;
      const far = step.states[nearSide === 0 ? 1 : 0] as Json;
      const made = {
        near: differenceOf(known[of] ?? null, near),
        far: differenceOf(near, far),
        ...(table && { table }),
      };
      known[of] = far;
      size += JSON.stringify(made).length;
      if (size > MOST.size / 4) break;
      found.push(made);
    }
    if (found.length >= MOST.steps) break;
  }
  return found;
}

const printsOfTables = (): Readonly<Record<string, string>> =>
  Object.fromEntries(undoneRecords().map(({ key, now }) => [key, fingerprint(now())]));

function write(): void {
  flushEdits();
  const { job, program, work } = useEditor.getState();
  const present = job ?? program;
  try {
    KEPT.set(null);
    const { past, future } = useSteps.getState();
    if ((program?.text.length ?? 0) > MOST.size) return;
    const steps: KeptSteps = {
      work: work ?? "",
      print: fingerprint(present),
      tables: printsOfTables(),
      past: kept(past, present, 1),
      future: kept(future, present, 0),
      texts: program && work !== null ? [...textKeepers].flatMap((texts) => texts(work)) : [],
    };
    const text = JSON.stringify(steps);
    if (text.length <= MOST.size) KEPT.set(text);
  } catch {
    return;
  }
}

/** Starts writing the history when the page closes. */
export function startKeepingSteps(): () => void {
  const rest = () => {
    if (document.visibilityState === "hidden") write();
  };
  addEventListener("pagehide", write);
  document.addEventListener("visibilitychange", rest);
  return () => {
    removeEventListener("pagehide", write);
    document.removeEventListener("visibilitychange", rest);
  };
}

/** The stored history, read once; null if it is of another work, or the work has changed since. */
function taken(): KeptSteps | null {
  const { job, program, work } = useEditor.getState();
  const raw = jsonOf(KEPT.get()) as KeptSteps | null | undefined;
  if (raw?.work !== (work ?? "")) return null;
  KEPT.set(null);
  return raw.print === fingerprint(job ?? program) ? raw : null;
}

/** Restores the steps in history order; the one that is taken next is last. */
function stepsOf(
  list: readonly KeptStep[],
  same: readonly string[],
  nearSide: 0 | 1,
  textStep: (file: string) => HistoryStep | null,
) {
  const { job, program, work } = useEditor.getState();
  const known = knownNow(job ?? program);
  const steps: HistoryStep[] = [];
  for (const one of list) {
    if ("file" in one) {
      const step = textStep(one.file);
      if (!step) break;
      steps.push(step);
      continue;
    }
    const { table } = one;
    // Steps of a changed table are skipped; those of the work go on.
    if (table !== undefined && !same.includes(table)) continue;
    const of = table ?? WORK;
    const near = withDifference(known[of] ?? null, one.near);
    const far = withDifference(near, one.far);
    known[of] = far;
    const [before, after] = (nearSide === 1 ? [far, near] : [near, far]) as unknown[];
    const record = recordOf(table);
    if (record) {
      steps.push(stepBetween(record.put, before, after));
      continue;
    }
    steps.push(
      program
        ? stepBetween(putProgram(work) as (state: unknown) => boolean, before, after, OF_FILES)
        : stepBetween(putJob as (state: unknown) => void, before, after),
    );
  }
  return steps.reverse();
}

/**
 * Restores the history of the open work. For a program its editor restores the texts first and makes their steps; a
 * text that cannot be restored ends the history there.
 */
export function takeKeptSteps(
  putBack: ((texts: readonly KeptText[]) => (file: string) => HistoryStep | null) | null = null,
): void {
  if (useEditor.getState().program && !putBack) return;
  const record = taken();
  if (!record) return;
  try {
    const textStep = putBack?.(record.texts) ?? (() => null);
    const prints = printsOfTables();
    const same = Object.keys(prints).filter((name) => record.tables?.[name] === prints[name]);
    resumeSteps(stepsOf(record.past, same, 1, textStep), stepsOf(record.future, same, 0, textStep));
  } catch {
    return;
  }
}
