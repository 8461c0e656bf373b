import type { Task, TaskWords } from "../../../course/task.ts";
import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { fetchTask, useCourseIndex, type LessonEntry, type TaskEntry } from "../../../app/records/course/content.ts";
import { courseHref } from "../../../app/place/course-links.ts";
import { useTaskProgress } from "../../../app/records/course/progress.ts";
import { resumeOrStartTask, startTask } from "./begin.ts";
import { useTaskView } from "./task-view.ts";

interface LessonAndNextTask {
  readonly lesson: LessonEntry | null;
  readonly next: TaskEntry | null;
}

/** The lesson of a task, and the next task: in its lesson, or the first of a later one. */
export function lessonAndNextTask(lessons: readonly LessonEntry[], id: string): LessonAndNextTask {
  const all = lessons.flatMap((lesson) => lesson.tasks.map((task) => ({ lesson, task })));
  const index = all.findIndex(({ task }) => task.id === id);
  return { lesson: all[index]?.lesson ?? null, next: index < 0 ? null : (all[index + 1]?.task ?? null) };
}

/** Begins a task of the course. */
async function begin(id: string): Promise<void> {
  const task = await fetchTask(id);
  if (task) await resumeOrStartTask(task);
}

/** Starts the next task; nothing if there is none. */
function NextTask({ next, t }: { readonly next: TaskEntry | null; readonly t: CourseTaskTexts }) {
  return (
    next && (
      <button type="button" className="button primary task-next" onClick={() => void begin(next.id)}>
        <span>{t.nextTask(next.title)}</span>
      </button>
    )
  );
}

/** Below the line of a passed task while the assignment is folded: what you learned, and the next task. */
export function PassedLine({
  task,
  t,
  words,
}: {
  readonly task: Task;
  readonly t: CourseTaskTexts;
  readonly words: TaskWords;
}) {
  const { lessons } = useCourseIndex();
  return (
    <div className="task-now task-ways">
      <NextTask next={lessonAndNextTask(lessons, task.id).next} t={t} />
      {words.learned !== undefined && (
        <button type="button" className="button" onClick={() => useTaskView.setState({ open: true })}>
          <Icon name="down" /> {t.learned}
        </button>
      )}
    </div>
  );
}

/** After passing: what you learned, the next task, and the link to the lesson. */
export function TaskOnward({
  task,
  t,
  words,
}: {
  readonly task: Task;
  readonly t: CourseTaskTexts;
  readonly words: TaskWords;
}) {
  const { lessons } = useCourseIndex();
  const { passed } = useTaskProgress(task.id);
  const { lesson, next } = lessonAndNextTask(lessons, task.id);
  return (
    <section className="task-part task-onward">
      {passed && words.learned !== undefined && (
        <div className="task-learned">
          <h3>
            <Icon name="check" /> {t.learned}
          </h3>
          <p>{words.learned}</p>
        </div>
      )}
      <div className="task-ways">
        {passed && <NextTask next={next} t={t} />}
        <a className="button" href={courseHref(lesson?.id ?? null, "tasks")}>
          {lesson ? t.toLesson : t.toCourse}
        </a>
        <button type="button" className="button" onClick={() => startTask(task, !lesson)}>
          {t.startOver}
        </button>
      </div>
    </section>
  );
}
