import { lessonToContinue } from "../../course/path.ts";
import type { CourseProgress } from "../../course/progress.ts";
import type { LessonEntry } from "../../app/records/course/content.ts";
import { courseHref } from "../../app/place/course-links.ts";
import { GuideLinks } from "../../app/fields/said/GuideLinks.tsx";
import { ChapterList, LessonList } from "./ChapterList.tsx";
import { CourseReview } from "./CourseReview.tsx";
import { PathChoice } from "./PathChoice.tsx";
import { RestartCourse } from "./RestartCourse.tsx";
import { useLearning } from "../../app/records/course/progress.ts";
import { TaughtTasks } from "./teach/TaughtTasks.tsx";
import { useCoursePath } from "./use-course-path.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** The page to continue a lesson at: the one opened last, the exercises of a lesson that was read, else the first. */
const pageToContinue = ({ id }: LessonEntry, { last, read }: CourseProgress) =>
  last?.lesson === id ? last.page : read.includes(id) ? "tasks" : 1;

/** The chosen path through the course: its lessons with aims, exercises and progress, and the one to continue with. */
export function CourseList() {
  const t = useTexts("course");
  const chosen = useCoursePath();
  const { list } = useLearning();
  const { lessons, all } = chosen;
  const next = lessonToContinue(lessons, list);
  const isBegun = list.last !== null;
  return (
    <main className="course-page course-list">
      <div className="course-head">
        <div className="course-lead">
          <h1>{t.title}</h1>
          <p className="soft">{t.lead}</p>
        </div>
        {next && (
          <a className="button primary" href={courseHref(next.id, pageToContinue(next, list))}>
            {isBegun ? t.goOn(String(next.number), next.title) : t.begin(String(next.number))}
          </a>
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
