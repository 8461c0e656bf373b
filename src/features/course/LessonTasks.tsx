import { lessonAfter } from "../../course/path.ts";
import type { Lesson } from "../../course/lesson.ts";
import { progressOfTask, stateOfTask } from "../../course/progress.ts";
import { Icon } from "../../app/base/Icon.tsx";
import type { LessonEntry, TaskEntry } from "../../app/records/course/content.ts";
import { courseHref } from "../../app/place/course-links.ts";
import { beginTaskOfCourse } from "./begin-task.ts";
import { openLessonExample } from "./open-example.ts";
import { PassedBar } from "./PassedBar.tsx";
import { useLearning } from "../../app/records/course/progress.ts";
import { StepLinks } from "./StepLinks.tsx";
import { TaskStateMark } from "./TaskStateMark.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { lessonsAround, useCoursePath, useNextStep, useStudyTime } from "./use-course-path.ts";

function TaskList({ tasks, label }: { readonly tasks: readonly TaskEntry[]; readonly label: string }) {
  const t = useTexts("course");
  const studyTime = useStudyTime();
  const { list } = useLearning();
  return (
    <ol className="task-list" aria-labelledby={label}>
      {tasks.map(({ id, kind, title, seconds }) => (
        <li key={id}>
          <button type="button" className="button task-begin" onClick={() => void beginTaskOfCourse(id)}>
            <span className="task-words">
              <b>{title}</b>
              <span className="small soft">
                {t.kinds[kind]} · {studyTime(seconds)}
              </span>
            </span>
            <TaskStateMark state={stateOfTask(progressOfTask(list, id))} />
          </button>
        </li>
      ))}
    </ol>
  );
}

/**
 * The last page of a lesson: its aim, the tasks, the example to experiment with, and the way on. That is no button of
 * the foot: the second tap of a double tap on "To the exercises" would press it.
 */
export function LessonTasks({
  lesson,
  entry,
  aim,
}: {
  readonly lesson: Lesson;
  readonly entry: LessonEntry;
  readonly aim: string;
}) {
  const t = useTexts("course"),
    words = useTexts("course-path");
  const path = useCoursePath();
  const around = lessonsAround(path, entry.id);
  const { tasks } = around.find(({ id }) => id === entry.id) ?? entry;
  const more = entry.tasks.filter(({ id }) => tasks.every((task) => task.id !== id));
  const step = useNextStep({ lesson: entry.id });
  const next = step && lessonAfter(around, entry.id);
  const { example } = lesson;
  return (
    <div className="lesson-end">
      <p className="lesson-aim">{aim}</p>
      <section aria-labelledby="lesson-tasks">
        <div className="lesson-end-head">
          <h2 id="lesson-tasks" tabIndex={-1}>
            {t.tasks}
          </h2>
          <PassedBar lessons={around} />
        </div>
        {entry.tasks.length === 0 && <p className="soft">{t.noTasksYet}</p>}
        <TaskList tasks={tasks} label="lesson-tasks" />
      </section>
      {more.length > 0 && (
        <details className="lesson-more">
          <summary id="lesson-more">{words.more}</summary>
          <TaskList tasks={more} label="lesson-more" />
        </details>
      )}
      {example && (
        <section className="lesson-example">
          <button type="button" className="button" onClick={() => openLessonExample(example)}>
            <Icon name="rename" /> {t.example}
          </button>
          <p className="small soft">{t.exampleLead}</p>
        </section>
      )}
      <div className="lesson-onward">
        {step && step.kind !== "task" ? (
          <StepLinks step={step} />
        ) : (
          <a className={step ? "button" : "button primary"} href={courseHref(next?.id ?? null)}>
            {next ? t.nextLesson(String(next.number), next.title) : t.toList}
          </a>
        )}
      </div>
    </div>
  );
}
