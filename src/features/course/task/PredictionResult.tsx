import type { Task, TaskWords } from "../../../course/task.ts";
import type { ComparedAnswer } from "../../../course/predicted-answers.ts";
import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import type { Language } from "../../../i18n/languages.ts";
import { formatNumber } from "../../../i18n/number.ts";
import { part, type Pt } from "../../../kernel/geometry/point.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { retryPredictions } from "./predict.ts";
import { placeWords } from "./mark-words.ts";
import { useTaskView } from "./task-view.ts";

/** Decimals of sizes, areas and times next to a predicted value. */
const DECIMALS = 2;

/**
 * The prediction and the actual result, in a sentence. Where the same question is asked again, the right answer is not
 * revealed after a wrong one: the run shows it.
 */
function comparedText(
  { prediction, predicted, truth, right, block, isKept }: ComparedAnswer,
  t: CourseTaskTexts,
  language: Language,
  choices: readonly string[],
  reveals: boolean,
) {
  const { predict: words } = t;
  if (isKept) return words.kept;
  const say = (what: string, is: string) => {
    if (right) return words.right(is);
    if (!reveals) return words.wrongAgain(what);
    return block === null ? words.wrong(what, is) : `${words.wrong(what, is)} ${words.decides(String(block))}`;
  };
  // A choice may be a sentence; here it is part of one.
  const chosen = (choice: string | undefined) => (choice ?? "–").replace(/[.。]$/, "");
  if (truth.kind === "choice") return say(chosen(choices[Number(predicted)]), chosen(choices[truth.right]));
  if (truth.kind === "block")
    return right ? words.right(words.isBlock(String(predicted))) : words.wrongBlock(String(predicted));
  if (truth.kind === "place") {
    const name = (place: Pt) => t.where.place(...placeWords(language, place));
    const said = predicted as Pt;
    if (!truth.place) return words.doesNotOccur(name(said));
    if (right || !reveals) return say(name(said), name(truth.place));
    return words.wrongPlace(name(said), name(truth.place), formatNumber(language, part.apart(said, truth.place), 1));
  }
  const unit = prediction.ask in words.units ? ` ${words.units[prediction.ask as keyof typeof words.units]}` : "";
  const number = (value: number | null) => (value === null ? "–" : `${formatNumber(language, value, DECIMALS)}${unit}`);
  return say(`${formatNumber(language, Number(predicted))}${unit}`, number(truth.value));
}

/** The predictions and the actual results, while the picture shows the run. */
export function PredictionResult({
  task,
  t,
  words,
}: {
  readonly task: Task;
  readonly t: CourseTaskTexts;
  readonly words: TaskWords;
}) {
  const language = useSettings((s) => s.language);
  const predicted = useTaskView((v) => v.comparedAnswers);
  if (!predicted) return null;
  return (
    <div className="task-now task-predicted">
      <ul>
        {predicted.map((compared, i) => (
          <li key={i} className={compared.right ? "task-passed" : "task-failed"}>
            <Icon name={compared.right ? "check" : "close"} />
            <span>
              {predicted.length > 1 && <span className="soft">{words.questions?.[i]} </span>}
              {comparedText(compared, t, language, words.choices?.[i] ?? [], task.kind === "predict")}
            </span>
          </li>
        ))}
      </ul>
      {predicted.some(({ right }) => !right) && (
        <button type="button" className="button primary" onClick={() => void retryPredictions(task)}>
          {t.predict.again}
        </button>
      )}
    </div>
  );
}
