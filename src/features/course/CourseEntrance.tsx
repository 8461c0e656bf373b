import { lessonNumbers } from "virtual:course-index";
import { Icon } from "../../app/base/Icon.tsx";
import { courseHref } from "../../app/place/course-links.ts";
import { useLearning } from "../../app/records/course/progress.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import "./entrance.css";

/**
 * The way into the course on the start page: to its list, or for who has begun to the page that was open last. Its
 * lesson may have moved since: the number is that of today.
 */
export function CourseEntrance() {
  const { entrance: t } = useTexts("course");
  const last = useLearning((s) => s.list.last);
  return (
    <a className="course-entrance" href={last ? courseHref(last.lesson, last.page) : courseHref()}>
      <b>{t.name}</b>{" "}
      <span className="soft">{last ? t.goOn(String(lessonNumbers[last.lesson] ?? last.number)) : t.about}</span>
      <Icon name="fold" />
    </a>
  );
}
