import { Suspense } from "react";
import { lazyWithin } from "../../app/base/parts.ts";
import { lessonNumbers } from "virtual:course-index";
import { courseHref } from "../../app/place/course-links.ts";
import { useLearning } from "../../app/records/course/progress.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { EntranceWords } from "./EntranceWords.tsx";
import "./entrance.css";

const EntranceProgress = lazyWithin(async () => ({
  default: (await import("./EntranceProgress.tsx")).EntranceProgress,
}));

/**
 * Link to the course on the start page: to the list of lessons, or to the next step. Until that is loaded, to the page
 * opened last, with the current number of its lesson, which may have moved.
 */
export function CourseEntrance() {
  const { entrance: t } = useTexts("course");
  const last = useLearning((s) => s.list.last);
  const link = (
    <a className="course-entrance" href={last ? courseHref(last.lesson, last.page) : courseHref()}>
      <EntranceWords about={last ? t.goOn(String(lessonNumbers[last.lesson] ?? last.number)) : t.about} />
    </a>
  );
  return (
    <div className="course-way">
      {last ? (
        <Suspense fallback={link}>
          <EntranceProgress />
        </Suspense>
      ) : (
        link
      )}
    </div>
  );
}
