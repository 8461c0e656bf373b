import { useLearning } from "../../app/records/course/progress.ts";
import { courseHref } from "../../app/place/course-links.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { missedIn } from "../../course/path.ts";
import { EntranceWords } from "./EntranceWords.tsx";
import { PassedBar } from "./PassedBar.tsx";
import { MissedLink, useReviewWords } from "./StepLinks.tsx";
import { pageToContinue, useCoursePath, useNextStep } from "./use-course-path.ts";
import "./course.css";

/** On the start page, for who has begun the course: the next step, what is passed on the path, and what was missed. */
export function EntranceProgress() {
  const { entrance: t } = useTexts("course");
  const path = useTexts("course-path");
  const words = useReviewWords();
  const { lessons, all } = useCoursePath();
  const step = useNextStep();
  const { list } = useLearning();
  const missed = missedIn(all, list).length;
  const next = step?.lesson ?? null;
  const href = next ? courseHref(next.id, pageToContinue(next, list)) : courseHref();
  const goOn = next && t.goOn(String(next.number));
  const first = step?.kind === "review" ? step.missed[0] : undefined;
  return (
    <>
      {step?.kind === "review" && first ? (
        <MissedLink missed={first} className="course-entrance">
          <EntranceWords about={words(step.missed)} />
        </MissedLink>
      ) : (
        <a className="course-entrance" href={href}>
          <EntranceWords about={goOn ?? t.about} />
        </a>
      )}
      {first && goOn && (
        <a className="small" href={href}>
          {goOn}
        </a>
      )}
      <PassedBar lessons={lessons} />
      {!first && missed > 0 && (
        <a className="small" href={courseHref()}>
          {path.made.toReview(String(missed))}
        </a>
      )}
    </>
  );
}
