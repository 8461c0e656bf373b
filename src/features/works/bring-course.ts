import { mergedProgress, NO_PROGRESS, type CourseProgress } from "../../course/progress.ts";
import type { Task } from "../../course/task.ts";
import { bringProgress, startLearning, useLearning } from "../../app/records/course/progress.ts";
import { bringGathered, startGathered, useGathered } from "../../app/records/course/gathered.ts";
import { bringForms, keyOfWork, missingForms, startForms, useForms } from "../../app/records/course/kept-form.ts";
import { isAmong } from "../../app/records/course/result-rows.ts";
import { bringTasks, startTaught, useTaught } from "../../app/records/course/taught.ts";
import { bringWorked, startWorkingTime, useWorked } from "../../app/records/course/working-time.ts";
import { mergedWorked } from "../../app/records/course/worked-list.ts";
import type { ArchiveContent } from "../../app/records/archive.ts";
import { fingerprint } from "../../app/records/difference.ts";
import { asOneStep } from "../../app/document/steps.ts";

/** What an archive brings of the course: of learners and of instructors. */
export type BroughtCourse = Pick<ArchiveContent, "course" | "taught" | "forms" | "worked" | "results">;

/** The same of this device. */
export function courseHere() {
  startLearning();
  startTaught();
  startForms();
  startWorkingTime();
  startGathered();
  return {
    course: useLearning.getState().list,
    taught: useTaught.getState().list,
    forms: useForms.getState().list,
    worked: useWorked.getState().list,
    results: useGathered.getState().list,
  };
}

/** True where a progress in the course holds something that was not reached here. */
export const bringsProgress = (brought: CourseProgress, mine: CourseProgress): boolean =>
  fingerprint(mergedProgress(mine, brought)) !== fingerprint(mine);

/** True where an instructor's tasks are brought that are not here. */
export const bringsTasks = (brought: readonly Task[], mine: readonly Task[]): boolean =>
  brought.some(({ id }) => !mine.some((task) => task.id === id));

/** True where anything of a course is brought that is not here. */
export const bringsCourse = ({ course, taught, forms, worked, results }: BroughtCourse, mine: ReturnType<typeof courseHere>): boolean =>
  bringsProgress(course ?? NO_PROGRESS, mine.course)
  || bringsTasks(taught ?? [], mine.taught)
  || Object.keys(missingForms(forms ?? {}, mine.forms)).length > 0
  || fingerprint(mergedWorked(mine.worked, worked ?? {})) !== fingerprint(mine.worked)
  || (results ?? []).some(({ result }) => !isAmong(mine.results, result));

/** Takes what is brought of the course, as one step. `named`: works that have another name here than where they come from. */
export function takeCourse({ course, taught, forms, worked, results }: BroughtCourse, named: ReadonlyMap<string, string>): void {
  courseHere();
  const names = new Map([...named].map(([there, here]) => [keyOfWork(there), keyOfWork(here)] as const));
  asOneStep(() => {
    if (course) bringProgress(course);
    if (taught) bringTasks(taught);
    if (forms) bringForms(forms, names);
    if (worked) bringWorked(worked);
    if (results) bringGathered(results);
  });
}
