import { progressOfTask, stateOfTask } from "../../course/progress.ts";
import { useCourseIndex, type LessonEntry } from "../../app/records/course/content.ts";
import { courseHref } from "../../app/place/course-links.ts";
import { GuideLinks } from "../../app/fields/said/GuideLinks.tsx";
import { RestartCourse } from "./RestartCourse.tsx";
import { useLearning } from "../../app/records/course/progress.ts";
import { TaughtTasks } from "./teach/TaughtTasks.tsx";
import { TaskStateMark } from "./TaskStateMark.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** The lesson to continue with: the first one not done from the one opened last, else the first one not done at all. */
export function lessonToGoOn(
  lessons: readonly LessonEntry[],
  { list }: ReturnType<typeof useLearning.getState>,
): LessonEntry | null {
  const { last } = list;
  if (!last) return null;
  const at = lessons.findIndex(({ id }) => id === last.lesson);
  const isDone = (lesson: LessonEntry) =>
    list.read.includes(lesson.id) && lesson.tasks.every(({ id }) => progressOfTask(list, id).passed !== null);
  return (
    lessons.slice(Math.max(0, at)).find((lesson) => !isDone(lesson)) ??
    lessons.find((lesson) => !isDone(lesson)) ??
    null
  );
}

function LessonRow({ lesson, isNext }: { readonly lesson: LessonEntry; readonly isNext: boolean }) {
  const t = useTexts("course");
  const { list } = useLearning();
  const states = lesson.tasks.map((task) => ({ ...task, state: stateOfTask(progressOfTask(list, task.id)) }));
  const passed = states.filter(({ state }) => state !== "new" && state !== "tried").length;
  const progress =
    passed === states.length && passed > 0 ? t.allPassed : t.passed(String(passed), String(states.length));
  return (
    <li className="lesson-row" data-next={isNext}>
      <a className="lesson-link" href={courseHref(lesson.id)} aria-describedby={`aim-${lesson.id}`}>
        <span className="lesson-number number" aria-hidden="true">
          {lesson.number}
        </span>
        <h2>
          <span className="unseen">{t.lesson(String(lesson.number))}:</span> {lesson.title}
        </h2>
      </a>
      <p id={`aim-${lesson.id}`} className="lesson-aim soft">
        {lesson.aim}
      </p>
      <p className="lesson-progress small">
        {states.length === 0 && t.noTasks}
        {states.length > 0 && (
          <a href={courseHref(lesson.id, "tasks")}>
            {progress}
            <span className="unseen">, {t.lesson(String(lesson.number))}</span>
          </a>
        )}
        {list.read.includes(lesson.id) && ` · ${t.read}`}
        {isNext && <b>· {t.here}</b>}
      </p>
      {states.length > 0 && (
        <ul className="lesson-tasks small">
          {states.map(({ id, title, state }) => (
            <li key={id}>
              <span>{title}</span>
              <TaskStateMark state={state} />
            </li>
          ))}
        </ul>
      )}
    </li>
  );
}

/** All lessons with their aims, tasks and progress, and the one to continue with. */
export function CourseList() {
  const t = useTexts("course");
  const { lessons } = useCourseIndex();
  const learning = useLearning();
  const next = lessonToGoOn(lessons, learning);
  const [first] = lessons;
  const { last } = learning.list;
  return (
    <main className="course-page course-list">
      <div className="course-head">
        <div className="course-lead">
          <h1>{t.title}</h1>
          <p className="soft">{t.lead}</p>
        </div>
        {next && (
          <a className="button primary" href={courseHref(next.id, last?.lesson === next.id ? last.page : 1)}>
            {t.goOn(String(next.number), next.title)}
          </a>
        )}
        {!last && first && (
          <a className="button primary" href={courseHref(first.id)}>
            {t.begin}
          </a>
        )}
      </div>
      <ol className="lesson-list" aria-label={t.lessons}>
        {lessons.map((lesson) => (
          <LessonRow key={lesson.id} lesson={lesson} isNext={lesson === next} />
        ))}
      </ol>
      <GuideLinks />
      <TaughtTasks />
      <RestartCourse />
    </main>
  );
}
