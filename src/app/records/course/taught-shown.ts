import { create } from "zustand";
import type { HandedResult } from "../../../course/made/result.ts";
import type { Task } from "../../../course/task.ts";
import { gather, resultRecord } from "./gathered.ts";
import { isAmong, type LearnerFile } from "./result-rows.ts";
import type { FieldFault } from "../../../course/read-task.ts";

/**
 * Why nothing was read: more than is opened, of a newer edition, of another kind, no JSON (`line`: where that is seen,
 * from 1), cut or altered on its way, fields that are wrong, or a file that the browser does not give.
 */
export type TaughtProblem =
  | { readonly kind: "tooLarge" | "newer" | "foreign" | "damaged" | "unreadable" }
  | { readonly kind: "notJson"; readonly line: number | null }
  | { readonly kind: "fields"; readonly faults: readonly FieldFault[] };

/** A file that brought no results, by its name, and why: it is here already, holds a task, or cannot be read. */
export interface FileLeftOut {
  readonly file: string;
  readonly why: { readonly kind: "twice" } | { readonly kind: "task" } | TaughtProblem;
}

/**
 * Something of a course that came from outside, shown before anything becomes of it. `left`: fields of a task that
 * nobody knows.
 */
export type TaughtShown =
  | { readonly kind: "task"; readonly task: Task; readonly left: readonly string[] }
  | { readonly kind: "results"; readonly leftOut: readonly FileLeftOut[] }
  | { readonly kind: "problem"; readonly file: string; readonly problem: TaughtProblem };

export const useTaughtShown = create<{ readonly shown: TaughtShown | null }>(() => ({ shown: null }));

export const showTask = (task: Task, left: readonly string[] = []): void =>
  useTaughtShown.setState({ shown: { kind: "task", task, left } });
export const showProblem = (file: string, problem: TaughtProblem): void =>
  useTaughtShown.setState({ shown: { kind: "problem", file, problem } });
export const leaveTaught = (): void => useTaughtShown.setState({ shown: null });

/** A file of results, by its name; or why it brings none. */
export type NamedResult = { readonly file: string; readonly result: HandedResult } | FileLeftOut;

/**
 * Shows the gathered results, and what came beside them; each file once. What became of files that came before stays to
 * be seen.
 */
export function showResults(come: readonly NamedResult[] = []): void {
  const { shown } = useTaughtShown.getState();
  const list = resultRecord.now();
  const fresh: LearnerFile[] = [],
    leftOut: FileLeftOut[] = shown?.kind === "results" ? [...shown.leftOut] : [];
  for (const one of come) {
    if ("why" in one) leftOut.push(one);
    else if (isAmong([...list, ...fresh], one.result)) leftOut.push({ file: one.file, why: { kind: "twice" } });
    else fresh.push(one);
  }
  gather(fresh);
  const known = new Set<string>();
  const each = leftOut.filter((one) => {
    const key = JSON.stringify(one),
      isNew = !known.has(key);
    known.add(key);
    return isNew;
  });
  useTaughtShown.setState({ shown: { kind: "results", leftOut: each } });
}
