import { create } from "zustand";
import type { Answer, TaskJudgement } from "../../../course/judge/judgement.ts";
import type { ComparedAnswer } from "../../../course/told.ts";

/** What came of a check. */
export interface CheckedAnswer {
  readonly answer: Answer;
  readonly judgement: TaskJudgement;
  readonly passed: boolean;
}

/**
 * Why a check says nothing yet: empty prompts (by their names), a fault in one of them, no contour, nothing that cuts,
 * no result.
 */
export type NotReady =
  { readonly why: "empty"; readonly at: readonly string[] } | { readonly why: "noContour" | "noRun" | "notRun" };

/** What the panel of the open task shows; it belongs to the page, not to the work. */
export interface TaskView {
  /** Key of the work that this is of. */
  readonly work: string | null;
  /** The assignment is unfolded. */
  readonly open: boolean;
  readonly checking: boolean;
  readonly notReady: NotReady | null;
  readonly checked: CheckedAnswer | null;
  /** Something was changed since the check. */
  readonly stale: boolean;
  /** How the goals stand now, after the first check. */
  readonly live: TaskJudgement | null;
  /** What was foretold beside what is so, once the run was shown. */
  readonly foretold: readonly ComparedAnswer[] | null;
  /** The place that is looked at, from 0, and the question that is asked. */
  readonly place: number;
  readonly question: number;
}

const NOTHING: TaskView = {
  work: null,
  open: false,
  checking: false,
  notReady: null,
  checked: null,
  stale: false,
  live: null,
  foretold: null,
  place: 0,
  question: 0,
};

export const useTaskView = create<TaskView>(() => NOTHING);

/** Nothing is known of another work. What was unfolded before it was opened stays so. */
export const viewTask = (work: string): void =>
  useTaskView.setState((now) => (now.work === work ? now : { ...NOTHING, work, open: now.work === null && now.open }));

/** The next task that is opened shows its assignment. */
export const unfoldNext = (): void => useTaskView.setState({ ...NOTHING, open: true });
