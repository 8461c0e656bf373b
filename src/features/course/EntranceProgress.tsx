import { useLearning } from "../../app/records/course/progress.ts";
import { courseHref } from "../../app/place/course-links.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { missedIn } from "../../course/path.ts";
import { PassedBar } from "./PassedBar.tsx";
import { useCoursePath } from "./use-course-path.ts";
import "./course.css";

/** On the start page, for who has begun the course: what is passed on the chosen path, and what was missed. */
export function EntranceProgress() {
  const t = useTexts("course-path").made;
  const { lessons, all } = useCoursePath();
  const missed = useLearning((s) => missedIn(all, s.list).length);
  return (
    <>
      <PassedBar lessons={lessons} />
      {missed > 0 && (
        <a className="small" href={courseHref()}>
          {t.toReview(String(missed))}
        </a>
      )}
    </>
  );
}
