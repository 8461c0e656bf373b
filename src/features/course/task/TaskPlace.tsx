import type { Task } from "../../../course/task.ts";
import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import { useCourseIndex } from "../../../app/records/course/content.ts";

/** The lesson of a task and its number there; nothing for a task from outside. */
export function TaskPlace({ task, t }: { readonly task: Task; readonly t: CourseTaskTexts }) {
  const { lessons } = useCourseIndex();
  const lesson = lessons.find(({ tasks }) => tasks.some(({ id }) => id === task.id));
  if (!lesson) return null;
  const n = lesson.tasks.findIndex(({ id }) => id === task.id) + 1;
  return <span className="task-place soft small">{t.lessonTask(lesson.number, n, lesson.tasks.length)}</span>;
}
