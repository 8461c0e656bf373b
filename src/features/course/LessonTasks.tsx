import { useRef } from "react";
import type { Lesson } from "../../course/lesson.ts";
import { progressOfTask, stateOfTask } from "../../course/progress.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { fetchTask, type LessonEntry } from "../../app/records/course/content.ts";
import { openLessonExample } from "./open-example.ts";
import { useLearning } from "../../app/records/course/progress.ts";
import { resumeOrStartTask } from "./task/begin.ts";
import { TaskStateMark } from "./TaskStateMark.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** The last page of a lesson: its aim, the tasks, and the example to experiment with. */
export function LessonTasks({
  lesson,
  entry,
  aim,
}: {
  readonly lesson: Lesson;
  readonly entry: LessonEntry;
  readonly aim: string;
}) {
  const t = useTexts("course");
  const { list } = useLearning();
  const going = useRef(false);
  /** Clicked twice while the task is loading, the button still starts one work. */
  const begin = async (id: string) => {
    if (going.current) return;
    going.current = true;
    try {
      const task = await fetchTask(id);
      if (task) await resumeOrStartTask(task);
    } finally {
      going.current = false;
    }
  };
  const { example } = lesson;
  return (
    <div className="lesson-end">
      <p className="lesson-aim">{aim}</p>
      <section aria-labelledby="lesson-tasks">
        <h2 id="lesson-tasks">{t.tasks}</h2>
        {entry.tasks.length === 0 && <p className="soft">{t.noTasksYet}</p>}
        <ol className="task-list">
          {entry.tasks.map(({ id, kind, title }) => (
            <li key={id}>
              <button type="button" className="button task-begin" onClick={() => void begin(id)}>
                <span className="task-words">
                  <b>{title}</b>
                  <span className="small soft">{t.kinds[kind]}</span>
                </span>
                <TaskStateMark state={stateOfTask(progressOfTask(list, id))} />
              </button>
            </li>
          ))}
        </ol>
      </section>
      {example && (
        <section className="lesson-example">
          <button type="button" className="button" onClick={() => openLessonExample(example)}>
            <Icon name="rename" /> {t.example}
          </button>
          <p className="small soft">{t.exampleLead}</p>
        </section>
      )}
    </div>
  );
}
