import { putOwn, useOwn } from "../document/own-store.ts";
import { handOver, OF_FILES, putJob, putProgram, useEditor } from "../document/store.ts";
import { resumeSteps, stepBetween, useSteps, type HistoryStep } from "../document/steps.ts";
import { putTools, useTools } from "../document/tool-store.ts";
import type { Work } from "../document/work.ts";
import { withDifference, differenceOf, fingerprint, type Difference, type Json } from "./difference.ts";

/*
 * The history of the open work, of the tools and of the own cycles outlasts a reload of its tab. It is written when the page goes away, so
 * that typing never waits for it, and taken only for the very state it was written of.
 */

const KEY = "turnwise/steps";

/** Steps of one side that are written, and characters of all. */
const MOST = { steps: 200, size: 2_000_000 };

/** A text of a program as the editor writes it down, with its history and its cursor. */
export interface KeptText {
  readonly file: string;
  readonly state: unknown;
}

/** Tables of the device, whose steps stand between those of a work. */
const TABLES = {
  tools: { put: putTools, list: () => useTools.getState().list },
  own: { put: putOwn, list: () => useOwn.getState().list },
} as const;
type TableName = keyof typeof TABLES;
const NAMES = Object.keys(TABLES) as readonly TableName[];
const tableOf = (step: HistoryStep): TableName | undefined => NAMES.find((name) => TABLES[name].put === step.of);
const tablesNow = () => ({ tools: TABLES.tools.list(), own: TABLES.own.list() });
/** States that are known while steps are gone through, as they are in files. */
type Known = Partial<Record<TableName | "work", Json>>;
const knownNow = (present: Work | null) => ({ ...tablesNow(), work: present }) as unknown as Known;

/** A step: of a whole state, by what differs from the one that is known; or one step through the text of a file. */
type KeptStep = { readonly near: Difference; readonly far: Difference; readonly table?: TableName } | { readonly file: string };

interface KeptSteps {
  /** Empty where none was open. */
  readonly work: string;
  readonly print: string;
  /** Marks of the tables, whose steps count only for the same tables. */
  readonly tables?: Readonly<Record<TableName, string>>;
  /** Newest change first, and the other way next to be made again first. */
  readonly past: readonly KeptStep[];
  readonly future: readonly KeptStep[];
  readonly texts: readonly KeptText[];
}

/** Asked for the texts of a work when the page goes away. */
export const textKeepers = new Set<(work: string) => readonly KeptText[]>();

/** Steps of the open work and of the tables, as they go away from the present states; the first step of anything larger ends them. */
function kept(steps: readonly HistoryStep[], present: Work | null, nearSide: 0 | 1): readonly KeptStep[] {
  const found: KeptStep[] = [];
  const known = knownNow(present);
  let size = 0;
  for (const step of [...steps].reverse()) {
    const table = tableOf(step);
    const isWhole = present !== null && (step.of === putJob || step.of === OF_FILES);
    // Opening another work is where these end.
    if (step.file === undefined && !((isWhole || table) && step.states)) break;
    if (step.file !== undefined) found.push({ file: step.file });
    else if (step.states) {
      const of = table ?? "work";
      const near = step.states[nearSide] as Json;
      const far = step.states[nearSide === 0 ? 1 : 0] as Json;
      const made = { near: differenceOf(known[of] ?? null, near), far: differenceOf(near, far), ...(table && { table }) };
      known[of] = far;
      size += JSON.stringify(made).length;
      if (size > MOST.size / 4) break;
      found.push(made);
    }
    if (found.length >= MOST.steps) break;
  }
  return found;
}

const printsOfTables = () => {
  const { tools, own } = tablesNow();
  return { tools: fingerprint(tools), own: fingerprint(own) };
};

function write(): void {
  handOver();
  const { job, program, work } = useEditor.getState();
  const present = job ?? program;
  try {
    sessionStorage.removeItem(KEY);
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
    if (text.length <= MOST.size) sessionStorage.setItem(KEY, text);
  } catch {
    return;
  }
}

/** From now on the history is written when the page goes away. */
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

/** What was written of the work as it is now, once; null where it is another one, or was changed since. */
function taken(): KeptSteps | null {
  const { job, program, work } = useEditor.getState();
  try {
    const raw = JSON.parse(sessionStorage.getItem(KEY) ?? "null") as KeptSteps | null;
    if (!raw || raw.work !== (work ?? "")) return null;
    sessionStorage.removeItem(KEY);
    return raw.print === fingerprint(job ?? program) ? raw : null;
  } catch {
    return null;
  }
}

/** Steps again, in the order of the history: the one that is gone next stands last. */
function stepsOf(list: readonly KeptStep[], same: readonly TableName[], nearSide: 0 | 1, textStep: (file: string) => HistoryStep | null) {
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
    // The steps of a table that was changed since lead nowhere; those of the work go on.
    if (table !== undefined && !same.includes(table)) continue;
    const of = table ?? "work";
    const near = withDifference(known[of] ?? null, one.near);
    const far = withDifference(near, one.far);
    known[of] = far;
    const [before, after] = (nearSide === 1 ? [far, near] : [near, far]) as unknown[];
    if (table !== undefined) {
      steps.push(stepBetween(TABLES[table].put as (state: unknown) => void, before, after));
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
 * Takes the history of the open work up again. For a program its editor does that, which puts the texts back first and makes
 * their steps; a text that it cannot put back ends the history there.
 */
export function takeKeptSteps(putBack: ((texts: readonly KeptText[]) => (file: string) => HistoryStep | null) | null = null): void {
  if (useEditor.getState().program && !putBack) return;
  const record = taken();
  if (!record) return;
  try {
    const textStep = putBack?.(record.texts) ?? (() => null);
    const prints = printsOfTables();
    const same = NAMES.filter((name) => record.tables?.[name] === prints[name]);
    resumeSteps(stepsOf(record.past, same, 1, textStep), stepsOf(record.future, same, 0, textStep));
  } catch {
    return;
  }
}
