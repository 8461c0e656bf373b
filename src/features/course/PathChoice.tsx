import { useId } from "react";
import { lessonsOnPath } from "../../course/path.ts";
import { useCourseIndex } from "../../app/records/course/content.ts";
import { choosePath } from "../../app/records/course/progress.ts";
import { PassedBar } from "./PassedBar.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { secondsOfLessons, useStudyTime, type ChosenPath } from "./use-course-path.ts";

/** The paths through the course, each with its size, its time and the exercises passed on it. */
export function PathChoice({ chosen }: { readonly chosen: ChosenPath }) {
  const t = useTexts("course-path");
  const studyTime = useStudyTime();
  const { paths } = useCourseIndex();
  const name = useId();
  return (
    <fieldset className="path-choice">
      <legend className="unseen">{t.choose}</legend>
      {[null, ...paths].map((path) => {
        const lessons = lessonsOnPath(chosen.all, path);
        const { title, about } = path ?? t.whole;
        const tasks = lessons.reduce((sum, lesson) => sum + lesson.tasks.length, 0);
        return (
          <label key={path?.id ?? "whole"} className="path-card">
            <input
              type="radio"
              name={name}
              checked={chosen.id === (path?.id ?? null)}
              onChange={() => choosePath(path?.id ?? null)}
            />
            <span className="path-words">
              <b>{title}</b>
              <span className="soft">{about}</span>
              <span className="soft small">
                {t.size(String(lessons.length), String(tasks), studyTime(secondsOfLessons(lessons)))}
              </span>
              <PassedBar lessons={lessons} />
            </span>
          </label>
        );
      })}
    </fieldset>
  );
}
