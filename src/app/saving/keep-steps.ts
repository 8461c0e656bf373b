import { handOver, OF_FILES, putJob, putProgram, useEditor } from "../store.ts";
import { resumeSteps, stepBetween, useSteps, type HistoryStep } from "../steps.ts";
import type { Work } from "../work.ts";
import { withDifference, differenceOf, fingerprint, type Difference, type Json } from "./difference.ts";

/*
 * The history of the open work outlasts a reload of its tab. It is written when the page goes away, so that typing never waits for it,
 * and taken only for the very state it was written of.
 */

const KEY = "turnwise/steps";

/** Steps of one side that are written, and characters of all. */
const MOST = { steps: 200, size: 2_000_000 };

/** A text of a program as the editor writes it down, with its history and its cursor. */
export interface KeptText {
  readonly file: string;
  readonly state: unknown;
}

/** A step: of a whole state, by what differs from the one that is known; or one step through the text of a file. */
type KeptStep = { readonly near: Difference; readonly far: Difference } | { readonly file: string };

interface KeptSteps {
  readonly work: string;
  readonly print: string;
  /** Newest change first, and the other way next to be made again first. */
  readonly past: readonly KeptStep[];
  readonly future: readonly KeptStep[];
  readonly texts: readonly KeptText[];
}

/** Asked for the texts of a work when the page goes away. */
export const textKeepers = new Set<(work: string) => readonly KeptText[]>();

/** Steps of the work that is open, as they go away from its present state; the first step of anything larger ends them. */
function kept(steps: readonly HistoryStep[], present: Work, nearSide: 0 | 1): readonly KeptStep[] {
  const found: KeptStep[] = [];
  let known = present as unknown as Json;
  let size = 0;
  for (const step of [...steps].reverse()) {
    const isWhole = step.of === putJob || step.of === OF_FILES;
    if (step.file === undefined && !(isWhole && step.states)) {
      // Tools and own cycles have steps in between; opening another work is where these end.
      if (isBeside(step)) continue;
      break;
    }
    if (step.file !== undefined) found.push({ file: step.file });
    else if (step.states) {
      const near = step.states[nearSide] as Json;
      const far = step.states[nearSide === 0 ? 1 : 0] as Json;
      const made = { near: differenceOf(known, near), far: differenceOf(near, far) };
      known = far;
      size += JSON.stringify(made).length;
      if (size > MOST.size / 4) break;
      found.push(made);
    }
    if (found.length >= MOST.steps) break;
  }
  return found;
}

/** A step of what belongs to no work. */
const isBeside = (step: HistoryStep): boolean => Array.isArray(step.states?.[0]);

function write(): void {
  handOver();
  const { job, program, work } = useEditor.getState();
  const present = job ?? program;
  try {
    sessionStorage.removeItem(KEY);
    const { past, future } = useSteps.getState();
    if (!present || work === null || (program?.text.length ?? 0) > MOST.size) return;
    const steps: KeptSteps = {
      work,
      print: fingerprint(present),
      past: kept(past, present, 1),
      future: kept(future, present, 0),
      texts: program ? [...textKeepers].flatMap((texts) => texts(work)) : [],
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
    if (!raw || work === null || raw.work !== work) return null;
    sessionStorage.removeItem(KEY);
    return raw.print === fingerprint(job ?? program) ? raw : null;
  } catch {
    return null;
  }
}

/** Steps again, in the order of the history: the one that is gone next stands last. */
function stepsOf(list: readonly KeptStep[], present: Work, nearSide: 0 | 1, textStep: (file: string) => HistoryStep | null) {
  const { work } = useEditor.getState();
  let known = present as unknown as Json;
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
    const [before, after] = (nearSide === 1 ? [far, near] : [near, far]) as unknown[];
    steps.push(
      "text" in present
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
  const { job, program } = useEditor.getState();
  const present = job ?? program;
  if (!present || (program && !putBack)) return;
  const record = taken();
  if (!record) return;
  try {
    const textStep = putBack?.(record.texts) ?? (() => null);
    resumeSteps(stepsOf(record.past, present, 1, textStep), stepsOf(record.future, present, 0, textStep));
  } catch {
    return;
  }
}
