import { passedOf, stateOfLesson } from "../../course/path.ts";
import { progressOfTask, stateOfTask } from "../../course/progress.ts";
import type { LessonEntry } from "../../app/records/course/content.ts";
import { courseHref } from "../../app/place/course-links.ts";
import { useLearning } from "../../app/records/course/progress.ts";
import { beginTaskOfCourse } from "./begin-task.ts";
import { StateMark, TaskStateMark } from "./TaskStateMark.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { secondsOfLessons, useStudyTime } from "./use-course-path.ts";

/** A lesson of the list: its aim, its time, how far it is done, and its exercises. */
export function LessonRow({ lesson, isNext }: { readonly lesson: LessonEntry; readonly isNext: boolean }) {
  const t = useTexts("course"),
    path = useTexts("course-path");
  const studyTime = useStudyTime();
  const { list } = useLearning();
  const { passed, of } = passedOf([lesson], list);
  const state = stateOfLesson(lesson, list);
  return (
    <li className="lesson-row" data-next={isNext} data-state={state}>
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
        <StateMark
          form={state === "done" ? "alone" : state === "begun" ? "tried" : "new"}
          words={path.lessonStates[state]}
        />
        {of > 0 && <span>{t.passed(String(passed), String(of))}</span>}
        <span>{studyTime(secondsOfLessons([lesson]))}</span>
      </p>
      {of > 0 && (
        <ul className="lesson-tasks small">
          {lesson.tasks.map(({ id, title }) => (
            <li key={id}>
              <button
                type="button"
                className="task-link"
                aria-label={path.beginTask(title)}
                aria-describedby={`state-${id}`}
                onClick={() => void beginTaskOfCourse(id)}
              >
                {title}
              </button>
              <span id={`state-${id}`}>
                <TaskStateMark state={stateOfTask(progressOfTask(list, id))} />
              </span>
            </li>
          ))}
        </ul>
      )}
    </li>
  );
}
