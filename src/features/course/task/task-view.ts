import { create } from "zustand";
import type { Answer, TaskJudgement } from "../../../course/judge/judgement.ts";
import type { ComparedAnswer } from "../../../course/predicted-answers.ts";

/** The result of a check. */
export interface CheckedAnswer {
  readonly answer: Answer;
  readonly judgement: TaskJudgement;
  readonly passed: boolean;
}

/**
 * Why a check cannot judge yet: empty prompts (by their names), a cycle without its call, no contour, nothing that
 * cuts, no result.
 */
export type NotReady =
  | { readonly why: "empty"; readonly at: readonly string[] }
  | { readonly why: "noCall"; readonly cycle: number }
  | { readonly why: "noContour" | "noRun" | "notRun" };

/** View state of the task panel; it belongs to the page, not to the work. */
export interface TaskView {
  /** Key of the work that this state belongs to. */
  readonly work: string | null;
  /** The assignment is unfolded. */
  readonly open: boolean;
  /** The workshop drawing is shown as a second picture; null: as is usual for the task. */
  readonly drawn: boolean | null;
  readonly checking: boolean;
  readonly notReady: NotReady | null;
  readonly checked: CheckedAnswer | null;
  /** The work has changed since the check. */
  readonly stale: boolean;
  /** The goals of the current work, after the first check. */
  readonly live: TaskJudgement | null;
  /** The predictions and the actual results, once the run is shown. */
  readonly comparedAnswers: readonly ComparedAnswer[] | null;
  /** The shown mark, from 0, and the current question, from 0. */
  readonly place: number;
  readonly question: number;
}

const NOTHING: TaskView = {
  work: null,
  open: false,
  drawn: null,
  checking: false,
  notReady: null,
  checked: null,
  stale: false,
  live: null,
  comparedAnswers: null,
  place: 0,
  question: 0,
};

export const useTaskView = create<TaskView>(() => NOTHING);

/** Resets the state for another work. An assignment unfolded in advance stays unfolded. */
export const viewTask = (work: string): void =>
  useTaskView.setState((now) => (now.work === work ? now : { ...NOTHING, work, open: now.work === null && now.open }));

/** The next opened task starts with its assignment unfolded. */
export const unfoldNext = (): void => useTaskView.setState({ ...NOTHING, open: true });
