import { Suspense } from "react";
import { lazyPart } from "../../app/base/parts.ts";
import { lessonNumbers } from "virtual:course-index";
import { Icon } from "../../app/base/Icon.tsx";
import { courseHref } from "../../app/place/course-links.ts";
import { useLearning } from "../../app/records/course/progress.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import "./entrance.css";

const EntranceProgress = lazyPart(async () => ({ default: (await import("./EntranceProgress.tsx")).EntranceProgress }));

/**
 * Link to the course on the start page: to the list of lessons, or to the page opened last. Uses the current number of
 * that lesson, which may have moved.
 */
export function CourseEntrance() {
  const { entrance: t } = useTexts("course");
  const last = useLearning((s) => s.list.last);
  return (
    <div className="course-way">
      <a className="course-entrance" href={last ? courseHref(last.lesson, last.page) : courseHref()}>
        <b>{t.name}</b>{" "}
        <span className="soft">{last ? t.goOn(String(lessonNumbers[last.lesson] ?? last.number)) : t.about}</span>
        <Icon name="fold" />
      </a>
      {last && (
        <Suspense>
          <EntranceProgress />
        </Suspense>
      )}
    </div>
  );
}
