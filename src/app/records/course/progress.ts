import { create } from "zustand";
import { isEmptyProgress, mergedProgress, NO_PROGRESS, progressOfTask, readProgress, withHint, withPass, withPlace, withSolution, withTry,
  type CourseMark, type PassedAnswer, type CourseProgress, type TaskProgress } from "../../../course/progress.ts";
import { time } from "../../base/clock.ts";
import { keepTable } from "../../base/device-table.ts";
import { noteChange } from "../../document/steps.ts";

/** How far this device's learner has come. `damaged`: what was kept could not be read and was set aside. */
export interface Learning {
  readonly list: CourseProgress;
  readonly trouble: "none" | "damaged" | "notKept";
}

export const useLearning = create<Learning>(() => ({ list: NO_PROGRESS, trouble: "none" }));

/** Where the progress is kept. */
export const PROGRESS_KEY = "turnwise/course";

let kept = false;

/** Reads the progress of this device and keeps each change from now on, in all tabs. Asked again it does nothing. */
export function startLearning(): void {
  if (kept) return;
  kept = true;
  keepTable<CourseProgress>({
    key: PROGRESS_KEY,
    aside: `${PROGRESS_KEY}/damaged`,
    store: useLearning,
    first: NO_PROGRESS,
    isSame: (one, other) => JSON.stringify(one) === JSON.stringify(other),
    write: (list) => (isEmptyProgress(list) ? null : JSON.stringify(list)),
    read: readProgress,
    take: put,
    damaged: () => useLearning.setState({ trouble: "damaged" }),
    notKept: () => useLearning.setState({ trouble: "notKept" }),
  });
}

const put = (list: CourseProgress): void => useLearning.setState({ list });
const change = (by: (progress: CourseProgress) => CourseProgress): void => {
  startLearning();
  const { list } = useLearning.getState();
  const next = by(list);
  if (next !== list) put(next);
};

/** What is known of a task, by its id. */
export const taskProgress = (task: string): TaskProgress => progressOfTask(useLearning.getState().list, task);
export const useTaskProgress = (task: string): TaskProgress => useLearning((s) => progressOfTask(s.list, task));

/** An answer to a task was checked, whether it passed or not. */
export const noteTry = (task: string): void => change((now) => withTry(now, task));
/** The hint of a task was shown up to a stage, from 1 to 3. */
export const noteHint = (task: string, stage: number): void => change((now) => withHint(now, task, stage));
/** The solution of a task was shown. */
export const noteSolution = (task: string): void => change((now) => withSolution(now, task));
/** An answer passed. Which way it counts as follows from the hints and the solution that were shown before. */
export const notePass = (task: string, worth: Omit<PassedAnswer, "when"> = {}): void =>
  change((now) => withPass(now, task, { ...worth, when: time() }));
/** A page of a lesson was opened. */
export const noteLessonPage = (at: CourseMark): void => change((now) => withPlace(now, at));

/** Puts another progress in place, as a step of undo. */
function replace(next: CourseProgress): void {
  const { list } = useLearning.getState();
  put(next);
  noteChange(put, list, next);
}

/** Takes what was reached on another device; what is better here stays. */
export function bringProgress(brought: CourseProgress): void {
  startLearning();
  replace(mergedProgress(useLearning.getState().list, brought));
}

/** The course begins anew: one step, which undo takes back. */
export function beginCourseAnew(): void {
  startLearning();
  if (!isEmptyProgress(useLearning.getState().list)) replace(NO_PROGRESS);
}
