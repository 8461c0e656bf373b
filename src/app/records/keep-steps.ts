import { jsonOf, storedText } from "../base/storage.ts";
import { undoneRecords } from "../base/record.ts";
import { documentOfWork, workOfDocument } from "../document/documents.ts";
import { flushEdits, knownState, openContent, useEditor, workStep } from "../document/store.ts";
import { historyOf, resumeSteps, stepBetween, useSteps, type DocumentId, type HistoryStep } from "../document/steps.ts";
import { isProgram, type Work } from "../document/work.ts";
import { withDifference, differenceOf, fingerprint, type Difference, type Json } from "./difference.ts";

/*
 * The undo histories of the works, the tools and the own cycles survive a reload. They are written when the page
 * closes, so that typing never waits for it, and used only for the same state.
 */

const KEPT = storedText("steps", "tab");

/** Most steps in one direction, and characters of one history and in total. */
const MOST = { steps: 200, history: 500_000, size: 2_000_000 };

/** A program text as the editor saves it, with history and cursor. */
export interface KeptText {
  readonly file: string;
  readonly state: unknown;
}

/** A step: the difference of a whole state from the known one, or one step in the text of a file. */
type KeptStep = { readonly near: Difference; readonly far: Difference } | { readonly file: string };

/** The history of one document. */
interface KeptHistory {
  readonly document: DocumentId;
  /** Fingerprint of the state that it belongs to. */
  readonly print: string;
  /** Newest change first; in `future` the next redo first. */
  readonly past: readonly KeptStep[];
  readonly future: readonly KeptStep[];
  readonly texts: readonly KeptText[];
}

/** Called for the texts of a work when the page closes. */
export const textKeepers = new Set<(work: string) => readonly KeptText[]>();

const recordOf = (document: DocumentId) => undoneRecords().find((each) => each.document === document);

/** The present state of a document whose history is stored; null for others. */
function presentOf(document: DocumentId): Json {
  const work = workOfDocument(document);
  return (work === null ? (recordOf(document)?.now() ?? null) : knownState(work)) as Json;
}

/** Steps of a document, from its present state outwards, up to the first larger step. */
function kept(steps: readonly HistoryStep[], present: Json, nearSide: 0 | 1): readonly KeptStep[] {
  const found: KeptStep[] = [];
  let known = present;
  let size = 0;
  for (const step of steps.slice(-MOST.steps).reverse()) {
    if (step.file !== undefined) {
      found.push({ file: step.file });
      continue;
    }
    if (!step.states) break;
    const near = step.states[nearSide] as Json;
    const far = step.states[nearSide === 0 ? 1 : 0] as Json;
    const made = { near: differenceOf(known, near), far: differenceOf(near, far) };
    known = far;
    size += JSON.stringify(made).length;
    if (size > MOST.history) break;
    found.push(made);
  }
  return found;
}

function keptHistory(document: DocumentId): KeptHistory | null {
  const present = presentOf(document);
  if (present === null) return null;
  const { past, future } = historyOf(document);
  const work = workOfDocument(document),
    content = present as unknown as Work;
  return {
    document,
    print: fingerprint(present),
    past: kept(past, present, 1),
    future: kept(future, present, 0),
    texts: work !== null && isProgram(content) ? [...textKeepers].flatMap((texts) => texts(work)) : [],
  };
}

/** Writes the histories, that of the open work first, as many as there is room for. */
function write(): void {
  flushEdits();
  const open = documentOfWork(useEditor.getState().work);
  const here = [...useSteps.getState().histories.keys()].reverse();
  const documents = [...here.filter((each) => each === open), ...here.filter((each) => each !== open)];
  try {
    const unused = readStored().filter(({ document }) => !documents.includes(document));
    KEPT.set(null);
    let size = 0;
    const histories = [...documents.map(keptHistory), ...unused].filter((each) => {
      size += each ? JSON.stringify(each).length : 0;
      return each && size < MOST.size;
    });
    if (histories.length > 0) KEPT.set(JSON.stringify({ histories }));
  } catch {
    return;
  }
}

/**
 * The stored histories: of the previous page, and of works that were not opened since. Those that an earlier version
 * stored in another form are dropped.
 */
function readStored(): readonly KeptHistory[] {
  const raw = jsonOf(KEPT.get()) as { readonly histories?: unknown } | null | undefined;
  const all: readonly (KeptHistory | null)[] = Array.isArray(raw?.histories) ? raw.histories : [];
  return all.filter((each): each is KeptHistory => typeof each?.document === "string");
}

/** Starts writing the histories when the page closes. */
export function startKeepingSteps(): () => void {
  const rest = () => {
    if (document.visibilityState === "hidden") write();
  };
  addEventListener("pagehide", write);
  document.addEventListener("visibilitychange", rest);
  // The text editor asks for the history of a program.
  const stop = useEditor.subscribe((now, before) => {
    if (now.work !== before.work && now.job) takeKeptSteps();
  });
  return () => {
    stop();
    removeEventListener("pagehide", write);
    document.removeEventListener("visibilitychange", rest);
  };
}

/** Restores the steps of a document in history order; the one that is taken next is last. */
function stepsOf(
  document: DocumentId,
  list: readonly KeptStep[],
  nearSide: 0 | 1,
  textStep: (file: string) => HistoryStep | null,
): readonly HistoryStep[] {
  const work = workOfDocument(document);
  const record = recordOf(document);
  let known = presentOf(document);
  const steps: HistoryStep[] = [];
  for (const one of list) {
    if ("file" in one) {
      const step = textStep(one.file);
      if (!step) break;
      steps.push(step);
      continue;
    }
    const near = withDifference(known, one.near);
    const far = withDifference(near, one.far);
    known = far;
    const [before, after] = (nearSide === 1 ? [far, near] : [near, far]) as unknown as [Work, Work];
    steps.push(record ? stepBetween(document, record.put, before, after) : workStep(work, before, after));
  }
  return steps.reverse();
}

type PutBack = (texts: readonly KeptText[]) => (file: string) => HistoryStep | null;

function resume(of: KeptHistory, putBack: PutBack | null): void {
  try {
    if (of.print !== fingerprint(presentOf(of.document))) return;
    const textStep = putBack?.(of.texts) ?? (() => null);
    resumeSteps(of.document, {
      past: stepsOf(of.document, of.past, 1, textStep),
      future: stepsOf(of.document, of.future, 0, textStep),
    });
  } catch {
    return;
  }
}

/**
 * Restores the history of the open work, and those of the tables. For a program its editor restores the texts first and
 * makes their steps; a text that cannot be restored ends the history there.
 */
export function takeKeptSteps(putBack: PutBack | null = null): void {
  const open = documentOfWork(useEditor.getState().work);
  const content = openContent();
  const isReady = content !== null && (putBack !== null || !isProgram(content));
  const isDue = ({ document }: KeptHistory) => (document === open ? isReady : recordOf(document) !== undefined);
  const all = readStored();
  const due = all.filter(isDue);
  if (due.length === 0) return;
  const rest = all.filter((each) => !isDue(each));
  KEPT.set(rest.length === 0 ? null : JSON.stringify({ histories: rest }));
  for (const each of due) resume(each, putBack);
}
