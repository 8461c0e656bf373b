import { create } from "zustand";
import type { Task } from "../../../course/task.ts";
import type { TaskSet } from "../../../course/task-set.ts";
import type { FieldFault } from "../../../course/read-task.ts";

/**
 * Why a file was not read: too large, a newer edition, another kind, no JSON (`line`: where, from 1), cut or altered,
 * wrong fields, or not readable by the browser.
 */
export type CourseFileProblem =
  | { readonly kind: "tooLarge" | "newer" | "foreign" | "damaged" | "unreadable" }
  | { readonly kind: "notJson"; readonly line: number | null }
  | { readonly kind: "fields"; readonly faults: readonly FieldFault[] };

/** A file without new results, and why: it is here already, holds a task or a set, or cannot be read. */
export interface FileLeftOut {
  readonly file: string;
  readonly why: { readonly kind: "twice" } | { readonly kind: "task" } | CourseFileProblem;
}

/**
 * What the dialog of the course shows: a task, a set or results from outside, before they are used (`left`: unknown
 * fields); the terms of an exam; a set being made; results being handed in, of a set or of chosen tasks.
 */
export type OpenedCourseFile =
  | { readonly kind: "task"; readonly task: Task; readonly left: readonly string[] }
  | { readonly kind: "set"; readonly set: TaskSet; readonly left: readonly string[] }
  | { readonly kind: "exam" | "makeSet"; readonly id: string }
  | { readonly kind: "handIn"; readonly id: string | null }
  | { readonly kind: "results"; readonly leftOut: readonly FileLeftOut[] }
  | { readonly kind: "problem"; readonly file: string; readonly problem: CourseFileProblem };

/** The program of a learner that the table of results opened last: its work, whose it is, and the id of its task. */
interface OpenedSubmission {
  readonly work: string | null;
  readonly said: string;
  readonly task: string;
}

export const useOpenedCourseFile = create<{
  readonly shown: OpenedCourseFile | null;
  readonly submission: OpenedSubmission | null;
}>(() => ({ shown: null, submission: null }));

export const showTask = (task: Task, left: readonly string[] = []): void =>
  useOpenedCourseFile.setState({ shown: { kind: "task", task, left } });
export const showSet = (set: TaskSet, left: readonly string[] = []): void =>
  useOpenedCourseFile.setState({ shown: { kind: "set", set, left } });
/** Shows the terms of an exam before it starts; the form of a set. */
export const showExamTerms = (id: string): void => useOpenedCourseFile.setState({ shown: { kind: "exam", id } });
export const showSetForm = (id: string): void => useOpenedCourseFile.setState({ shown: { kind: "makeSet", id } });
/** Shows what can be handed in: of a set, or of all tasks that were begun. */
export const showHandIn = (id: string | null): void => useOpenedCourseFile.setState({ shown: { kind: "handIn", id } });
export const showProblem = (file: string, problem: CourseFileProblem): void =>
  useOpenedCourseFile.setState({ shown: { kind: "problem", file, problem } });
export const closeCourseFile = (): void => useOpenedCourseFile.setState({ shown: null });
