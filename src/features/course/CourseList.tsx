import { GuideLinks } from "../../app/fields/said/GuideLinks.tsx";
import { ChapterList, LessonList } from "./ChapterList.tsx";
import { CourseReview } from "./CourseReview.tsx";
import { PathChoice } from "./PathChoice.tsx";
import { RestartCourse } from "./RestartCourse.tsx";
import { StepLinks } from "./StepLinks.tsx";
import { TaughtTasks } from "./teach/TaughtTasks.tsx";
import { useCoursePath, useNextStep } from "./use-course-path.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** The chosen path through the course: its lessons with aims, exercises and progress, and the one to continue with. */
export function CourseList() {
  const t = useTexts("course");
  const chosen = useCoursePath();
  const { lessons, all } = chosen;
  const step = useNextStep();
  const next = step?.lesson ?? null;
  return (
    <main className="course-page course-list">
      <div className="course-head">
        <div className="course-lead">
          <h1>{t.title}</h1>
          <p className="soft">{t.lead}</p>
        </div>
        {step && step.kind !== "task" && (
          <div className="course-ways">
            <StepLinks step={step} />
          </div>
        )}
      </div>
      <PathChoice chosen={chosen} />
      <CourseReview lessons={all} open={next === null} />
      <div className="course-chapters" role="group" aria-label={t.lessons}>
        {chosen.id === null ? (
          <ChapterList lessons={lessons} next={next} />
        ) : (
          <LessonList key={chosen.id} lessons={lessons} next={next} />
        )}
      </div>
      <GuideLinks />
      <TaughtTasks />
      <RestartCourse />
    </main>
  );
}
