import type { ReactNode } from "react";
import type { Missed, NextStep } from "../../course/path.ts";
import type { LessonEntry } from "../../app/records/course/content.ts";
import { courseHref } from "../../app/place/course-links.ts";
import { useLearning } from "../../app/records/course/progress.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { beginTaskOfCourse } from "./begin-task.ts";
import { pageToContinue, secondsOfMissed, useStudyTime } from "./use-course-path.ts";

/** Opens what was missed, to do it again: the page of a question, or the exercise, started over. */
export function MissedLink({
  missed,
  className = "button",
  children,
}: {
  readonly missed: Missed<LessonEntry>;
  readonly className?: string;
  readonly children: ReactNode;
}) {
  return missed.kind === "task" ? (
    <button type="button" className={className} onClick={() => void beginTaskOfCourse(missed.task.id, true)}>
      {children}
    </button>
  ) : (
    <a className={className} href={courseHref(missed.lesson.id, missed.page)}>
      {children}
    </a>
  );
}

/** Says how much there is to review, and how long it takes. */
export function useReviewWords(): (missed: readonly Missed<LessonEntry>[]) => string {
  const t = useTexts("course-path").review;
  const studyTime = useStudyTime();
  return (missed) => {
    const questions = missed.filter(({ kind }) => kind === "question").length;
    return t.step(questions, missed.length - questions, studyTime(secondsOfMissed(missed)));
  };
}

/** The next step as a button: the review, which begins with what was missed first, and beside it the next lesson. */
export function StepLinks({
  step,
  className = "button primary",
}: {
  readonly step: Exclude<NextStep<LessonEntry>, { kind: "task" }>;
  readonly className?: string;
}) {
  const t = useTexts("course");
  const words = useReviewWords();
  const { list } = useLearning();
  const { lesson } = step;
  const first = step.kind === "review" ? step.missed[0] : undefined;
  return (
    <>
      {step.kind === "review" && first && (
        <MissedLink missed={first} className={className}>
          {words(step.missed)}
        </MissedLink>
      )}
      {lesson && (
        <a className={first ? "button" : className} href={courseHref(lesson.id, pageToContinue(lesson, list))}>
          {list.last ? t.goOn(String(lesson.number), lesson.title) : t.begin(String(lesson.number))}
        </a>
      )}
    </>
  );
}
