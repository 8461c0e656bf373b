import { create } from "zustand";
import type { HandedResult } from "../../../course/made/result.ts";
import type { Task } from "../../../course/task.ts";
import { isAmong } from "./result-rows.ts";

/** Results of learners, with the names of files beside them that are none, and of those that were there already. */
export interface ShownResults {
  readonly kind: "results";
  readonly results: readonly HandedResult[];
  readonly notRead: readonly string[];
  readonly twice: readonly string[];
}

/** Something of a course that came from outside, shown before anything becomes of it. */
export type TaughtShown = { readonly kind: "task"; readonly task: Task } | ShownResults;

export const useTaughtShown = create<{ readonly shown: TaughtShown | null }>(() => ({ shown: null }));

export const showTask = (task: Task): void => useTaughtShown.setState({ shown: { kind: "task", task } });
export const leaveTaught = (): void => useTaughtShown.setState({ shown: null });

/** A file of results, by its name; without results where it holds none. */
export interface NamedResult {
  readonly file: string;
  readonly result: HandedResult | null;
}

/** Shows results, beside those that are shown already; each file once. */
export function showResults(come: readonly NamedResult[]): void {
  const { shown } = useTaughtShown.getState();
  const results = shown?.kind === "results" ? [...shown.results] : [];
  const notRead: string[] = [], twice: string[] = [];
  for (const { file, result } of come) {
    if (!result) notRead.push(file);
    else if (isAmong(results, result)) twice.push(file);
    else results.push(result);
  }
  useTaughtShown.setState({ shown: { kind: "results", results, notRead, twice } });
}
