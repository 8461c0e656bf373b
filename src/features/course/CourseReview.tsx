import { missedIn } from "../../course/path.ts";
import { progressOfTask, stateOfTask } from "../../course/progress.ts";
import type { LessonEntry } from "../../app/records/course/content.ts";
import { useLearning } from "../../app/records/course/progress.ts";
import { MissedLink } from "./StepLinks.tsx";
import { TaskStateMark } from "./TaskStateMark.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** Rows that are open at once. */
const FEW = 4;

/** What was missed, to do it again: exercises passed with help and questions answered wrongly. */
export function CourseReview({ lessons, open }: { readonly lessons: readonly LessonEntry[]; readonly open: boolean }) {
  const t = useTexts("course-path").review;
  const { list } = useLearning();
  const missed = missedIn(lessons, list);
  if (missed.length === 0) return null;
  return (
    <details className="chapter course-review" open={open || missed.length <= FEW}>
      <summary>
        <h2>{t.title(String(missed.length))}</h2>
        <span className="chapter-facts small">{t.lead}</span>
      </summary>
      <ul className="review-list">
        {missed.map((each) =>
          each.kind === "task" ? (
            <li key={each.task.id}>
              <MissedLink missed={each}>{t.repeat(each.task.title)}</MissedLink>
              <TaskStateMark state={stateOfTask(progressOfTask(list, each.task.id))} />
            </li>
          ) : (
            <li key={`${each.lesson.id} ${each.id}`}>
              <MissedLink missed={each}>{t.question(String(each.lesson.number), String(each.page))}</MissedLink>
              <span className="soft small">{each.lesson.title}</span>
            </li>
          ),
        )}
      </ul>
    </details>
  );
}
