import { useId, useState } from "react";
import type { Answer } from "../../../course/judge/judgement.ts";
import { isRight, type Truth } from "../../../course/judge/predicting.ts";
import { choicesOf, predictionOf } from "../../../course/made/made-questions.ts";
import type { QuestionDraft } from "../../../course/made/question-draft.ts";
import { answerKindOf, parsePredictedAnswer } from "../../../course/predicted-answers.ts";
import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import { formatFixed, formatNumber } from "../../../i18n/number.ts";
import { radius, toDiameter } from "../../../kernel/units.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { AskedAnswer } from "../task/AskedAnswer.tsx";
import { placeWords } from "../task/mark-words.ts";
import { QuestionPicture } from "./QuestionPicture.tsx";
import "../task/task.css";

/**
 * The learner's view of the questions, one at a time, over the part before its run. Accepts answers, and shows the
 * correct ones.
 */
export function QuestionPreview({
  questions,
  truths,
  begun,
}: {
  readonly questions: readonly QuestionDraft[];
  readonly truths: readonly (Truth | null)[];
  readonly begun: Answer;
}) {
  const t = useTexts("course-teach");
  const [shown, show] = useState(0);
  const [shows, toggle] = useState(true);
  const index = Math.min(shown, questions.length - 1),
    draft = questions[index];
  if (!draft) return null;
  return (
    <section className="teach-preview" aria-label={t.preview}>
      <h3>{t.preview}</h3>
      <p className="small soft">{t.previewHint}</p>
      {questions.length > 1 && (
        <div className="teach-choices" role="group" aria-label={t.questions}>
          {questions.map((_, i) => (
            <button key={i} type="button" className="button" aria-pressed={i === index} onClick={() => show(i)}>
              {t.question(String(i + 1))}
            </button>
          ))}
        </div>
      )}
      <label className="teach-check">
        <input type="checkbox" checked={shows} onChange={() => toggle(!shows)} />
        {t.showTruth}
      </label>
      <Asked key={`${index} ${draft.ask}`} draft={draft} truth={truths[index] ?? null} begun={begun} shows={shows} />
    </section>
  );
}

function Asked({
  draft,
  truth,
  begun,
  shows,
}: {
  readonly draft: QuestionDraft;
  readonly truth: Truth | null;
  readonly begun: Answer;
  readonly shows: boolean;
}) {
  const t = useTexts("course-teach"),
    task = useTexts("course-task");
  const language = useSettings((s) => s.language);
  const labelled = useId();
  const [text, say] = useState("");
  const prediction = predictionOf(draft);
  if (!prediction) return null;
  const said = parsePredictedAnswer(prediction, text),
    right = said !== null && truth !== null && isRight(prediction, truth, said);
  const place = answerKindOf(prediction) === "place";
  const within = "within" in prediction ? (prediction.within ?? 0) : 0;
  return (
    <div className="teach-asked">
      {place && (
        <QuestionPicture
          begun={begun}
          truth={shows && truth?.kind === "place" ? truth : null}
          within={within}
          said={said !== null && typeof said === "object" ? said : null}
          take={({ z, r }) =>
            say(`${formatFixed(language, toDiameter(radius(Math.abs(r))), 1)} ${formatFixed(language, z, 1)}`)
          }
        />
      )}
      <p id={labelled} className="task-question">
        <b>{draft.text}</b>
      </p>
      <AskedAnswer
        prediction={prediction}
        put={say}
        text={text}
        choices={choicesOf(draft)}
        t={task}
        labelled={labelled}
      />
      {shows && truth && <Right truth={truth} draft={draft} unit={unitOf(task, draft.ask)} />}
      <p role="status" className="teach-status">
        {said !== null && (
          <span className={right ? "teach-good" : "teach-bad"}>
            <Icon name={right ? "check" : "close"} /> {right ? t.isRight : t.isWrong}
          </span>
        )}
      </p>
    </div>
  );
}

/** Decimals of results of the run. */
const DECIMALS = 2;

const unitOf = ({ predict: { units } }: CourseTaskTexts, ask: string): string =>
  ask in units ? units[ask as keyof typeof units] : "";

/** The correct answer, in words. */
function Right({
  truth,
  draft,
  unit,
}: {
  readonly truth: Truth;
  readonly draft: QuestionDraft;
  readonly unit: string;
}) {
  const t = useTexts("course-teach");
  const language = useSettings((s) => s.language);
  switch (truth.kind) {
    case "number":
      return (
        <p>
          {truth.value === null
            ? t.noTruth
            : t.rightIs(`${formatNumber(language, truth.value, DECIMALS)} ${unit}`.trim())}
        </p>
      );
    case "choice":
      return <p>{t.rightIs(choicesOf(draft)[truth.right] ?? "–")}</p>;
    case "block":
      return <p>{t.rightIs(truth.right.join(", "))}</p>;
    case "place":
      return <p>{truth.place ? t.rightIs(t.place(...placeWords(language, truth.place))) : t.noTruth}</p>;
  }
}
