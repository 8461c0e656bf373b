import { useState } from "react";
import { markOfSet, SET_LIMITS, taskInSet, type TaskSet } from "../../../course/task-set.ts";
import type { Task } from "../../../course/task.ts";
import { inScreenLanguage } from "../../../course/words.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { Message } from "../../../app/base/Message.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { fetchTask, useCourseIndex } from "../../../app/records/course/content.ts";
import { useSavedTasks } from "../../../app/records/course/saved-tasks.ts";

interface Props {
  readonly set: TaskSet;
  readonly change: (some: Partial<TaskSet>) => void;
}

/** The tasks of a set in their order, and a menu that adds one: of the instructor, or of the course. */
export function SetTasks({ set, change }: Props) {
  const t = useTexts("course-set"),
    teach = useTexts("course-teach");
  const language = useSettings((s) => s.language);
  const own = useSavedTasks((s) => s.list);
  const { lessons } = useCourseIndex();
  const [said, say] = useState("");
  const { tasks } = set,
    mark = markOfSet(set.id);
  const titleOf = ({ words, id }: Task) => inScreenLanguage(words, language)?.title ?? id;
  const isIn = (id: string) => tasks.some((task) => task.id === taskInSet({ id } as Task, mark).id);
  const put = (next: readonly Task[]) => change({ tasks: [...next] });
  const add = async (id: string) => {
    const task = own.find((each) => each.id === id) ?? (await fetchTask(id));
    if (!task) return;
    put([...tasks, taskInSet(task, mark)]);
    say(t.added(titleOf(task)));
  };
  const move = (index: number, by: number) => {
    const moved = tasks[index];
    if (!moved) return;
    put(tasks.toSpliced(index, 1).toSpliced(index + by, 0, moved));
    say(t.movedTo(titleOf(moved), String(index + by + 1)));
  };
  /** The task as it was changed since it was added; null if it is the same. */
  const changed = (task: Task): Task | null => {
    const source = own.find((each) => taskInSet(each, mark).id === task.id);
    const now = source && taskInSet(source, mark);
    return now && JSON.stringify(now) !== JSON.stringify(task) ? now : null;
  };
  return (
    <fieldset>
      <legend>{t.tasks}</legend>
      {tasks.length === 0 && <Message tone="info">{t.noTasks}</Message>}
      <ol className="set-tasks">
        {tasks.map((task, i) => {
          const title = titleOf(task),
            newer = changed(task);
          return (
            <li key={task.id}>
              <span className="taught-name">
                {title} <span className="soft small">{teach.kinds[task.kind]}</span>
              </span>
              {newer && (
                <button type="button" className="button" onClick={() => put(tasks.with(i, newer))}>
                  {t.update}
                </button>
              )}
              <button
                type="button"
                className="button icon plain"
                aria-label={t.up(title)}
                aria-disabled={i === 0}
                onClick={() => i > 0 && move(i, -1)}
              >
                <Icon name="up" />
              </button>
              <button
                type="button"
                className="button icon plain"
                aria-label={t.down(title)}
                aria-disabled={i === tasks.length - 1}
                onClick={() => i < tasks.length - 1 && move(i, 1)}
              >
                <Icon name="down" />
              </button>
              <button
                type="button"
                className="button icon plain"
                aria-label={t.remove(title)}
                onClick={() => {
                  put(tasks.toSpliced(i, 1));
                  say(t.removed(title));
                }}
              >
                <Icon name="remove" />
              </button>
            </li>
          );
        })}
      </ol>
      <p role="status" className="unseen">
        {said}
      </p>
      {tasks.length < SET_LIMITS.tasks && (
        <label className="teach-text">
          {t.add}
          <select className="select" value="" onChange={(event) => void add(event.currentTarget.value)}>
            <option value="" disabled>
              {t.choose}
            </option>
            {own.length > 0 && (
              <optgroup label={t.own}>
                {own.map((task) => (
                  <option key={task.id} value={task.id} disabled={isIn(task.id)}>
                    {titleOf(task)}
                  </option>
                ))}
              </optgroup>
            )}
            {lessons.map((lesson) => (
              <optgroup key={lesson.id} label={`${lesson.number} ${lesson.title}`}>
                {lesson.tasks.map(({ id, title }) => (
                  <option key={id} value={id} disabled={isIn(id)}>
                    {title}
                  </option>
                ))}
              </optgroup>
            ))}
          </select>
        </label>
      )}
    </fieldset>
  );
}
