import type { Answer } from "../../../course/judge/judgement.ts";
import type { Truth } from "../../../course/judge/predicting.ts";
import {
  choicesOf,
  hasAt,
  hasOperation,
  hasWithin,
  hasAnswerInRun,
  proposedQuestion,
} from "../../../course/made/made-questions.ts";
import { ASKED_KINDS, type AskedKind, type QuestionDraft } from "../../../course/made/question-draft.ts";
import { withSign } from "../../../course/made/task-form.ts";
import { LESSON_LANGUAGES, SCREEN_LANGUAGES, type LessonLanguage } from "../../../i18n/languages.ts";
import { decimalSign, formatNumber } from "../../../i18n/number.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { Message } from "../../../app/base/Message.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { placeWords } from "../task/mark-words.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { TeachText, type FormPart } from "./WordFields.tsx";

/** Proposed kinds of a new question, unless already asked. */
const PROPOSED_KINDS: readonly AskedKind[] = ["passes", "infeed", "choice", "seconds"];

interface QuestionsProps extends FormPart {
  /** The run of the start program; null without one. */
  readonly begun: Answer | null;
  /** The text of the solution. */
  readonly solution: string;
  readonly truths: readonly (Truth | null)[];
}

/** The questions before the run. The correct answer comes from the run, at each keystroke. */
export function QuestionFields({ made, change, begun, solution, truths }: QuestionsProps) {
  const t = useTexts("course-teach");
  const sign = useSettings((s) => decimalSign(s.language));
  const { questions, sizes, translations = {} } = made;
  const languages = LESSON_LANGUAGES.filter((each) => translations[each] !== undefined);
  const worded = (ask: AskedKind, at: string): string => {
    const wording = t.wordings[ask];
    return typeof wording === "string" ? wording : wording(at);
  };
  const proposed = (ask: AskedKind): QuestionDraft | null => {
    const at = withSign(String(sizes.find(({ kind }) => kind === ask)?.at ?? 0), sign);
    if (!begun) return null;
    const draft = proposedQuestion(ask, begun, { solution, at, fates: t.fates });
    return { ...draft, within: withSign(draft.within, sign), text: worded(ask, at) };
  };
  const put = (index: number, some: Partial<QuestionDraft>) =>
    change({ questions: questions.map((each, i) => (i === index ? { ...each, ...some } : each)) });
  /** Proposed wording that was not edited follows the kind and place of the question. */
  const isProposed = ({ ask: asked, at, text }: QuestionDraft) => text.trim() === "" || text === worded(asked, at);
  const ask = (index: number, draft: QuestionDraft, next: AskedKind) => {
    const now = proposed(next);
    if (now) put(index, isProposed(draft) ? now : { ...now, text: draft.text });
  };
  const putTyped = (index: number, draft: QuestionDraft, some: Partial<QuestionDraft>) =>
    put(index, some.at === undefined || !isProposed(draft) ? some : { ...some, text: worded(draft.ask, some.at) });
  return (
    <fieldset>
      <legend>{t.questions}</legend>
      <p className="small soft">{t.questionsHint}</p>
      {questions.map((draft, i) => (
        <OneQuestion
          key={i}
          index={i}
          draft={draft}
          truth={truths[i] ?? null}
          begun={begun}
          languages={languages}
          put={(some) => putTyped(i, draft, some)}
          ask={(next) => ask(i, draft, next)}
          remove={() => change({ questions: questions.filter((_, at) => at !== i) }, true)}
        />
      ))}
      <div className="modal-ways">
        <button
          type="button"
          className="button"
          disabled={!begun}
          onClick={() => {
            const fresh =
              ASKED_KINDS.find((each) => PROPOSED_KINDS.includes(each) && !questions.some((q) => q.ask === each)) ??
              "choice";
            const made = proposed(fresh);
            if (made) change({ questions: [...questions, made] });
          }}
        >
          <Icon name="add" /> {t.addQuestion}
        </button>
      </div>
    </fieldset>
  );
}

interface OneProps {
  readonly index: number;
  readonly draft: QuestionDraft;
  readonly truth: Truth | null;
  readonly begun: Answer | null;
  /** The further languages that the task has. */
  readonly languages: readonly LessonLanguage[];
  readonly put: (some: Partial<QuestionDraft>) => void;
  readonly ask: (next: AskedKind) => void;
  readonly remove: () => void;
}

/** Wording and choices of a question in a further language. */
function Translated({
  draft,
  language,
  put,
}: {
  readonly draft: QuestionDraft;
  readonly language: LessonLanguage;
  readonly put: OneProps["put"];
}) {
  const t = useTexts("course-teach"),
    { textIn } = useTexts("course-set");
  const { text = "", choices = "" } = draft.translations?.[language] ?? {};
  const name = SCREEN_LANGUAGES[language].name;
  const say = (some: Partial<Record<"text" | "choices", string>>) =>
    put({ translations: { ...draft.translations, [language]: { text, choices, ...some } } });
  return (
    <>
      <TeachText label={textIn(t.wording, name)} rows={2} value={text} change={(next) => say({ text: next })} />
      {draft.ask === "choice" && (
        <TeachText
          label={textIn(t.choicesOffered, name)}
          rows={5}
          value={choices}
          change={(next) => say({ choices: next })}
        />
      )}
    </>
  );
}

function OneQuestion({ index, draft, truth, begun, languages, put, ask, remove }: OneProps) {
  const t = useTexts("course-teach");
  const number = String(index + 1),
    operations = begun?.run.operations ?? [],
    choices = choicesOf(draft);
  return (
    <section className="teach-question" aria-label={t.question(number)}>
      <div className="teach-question-head">
        <b>{t.question(number)}</b>
        <button type="button" className="button icon plain" aria-label={t.removeQuestion(number)} onClick={remove}>
          <Icon name="remove" />
        </button>
      </div>
      <div className="teach-pairs">
        <label className="teach-text">
          {t.asks}
          <select
            className="select"
            value={draft.ask}
            onChange={(event) => ask(event.currentTarget.value as AskedKind)}
          >
            {ASKED_KINDS.map((each) => (
              <option key={each} value={each}>
                {t.asked[each]}
              </option>
            ))}
          </select>
        </label>
        {hasOperation(draft.ask) && operations.length > 1 && (
          <label className="teach-text">
            {t.ofCall}
            <select
              className="select"
              value={draft.operation ?? ""}
              onChange={({ currentTarget: { value } }) => put({ operation: value === "" ? null : Number(value) })}
            >
              <option value="">{t.allCalls}</option>
              {operations.map(({ block, cycle }, i) => (
                <option key={i} value={i}>
                  {t.call(String(block), String(cycle))}
                </option>
              ))}
            </select>
          </label>
        )}
        {hasAt(draft.ask) && (
          <TeachText
            label={draft.ask === "face" ? t.atDiameter : t.atZ}
            value={draft.at}
            change={(at) => put({ at })}
          />
        )}
        {hasWithin(draft.ask) && (
          <TeachText label={t.within} value={draft.within} change={(within) => put({ within })} />
        )}
        {draft.ask === "block" && (
          <TeachText label={t.rightBlocks} value={draft.right} change={(right) => put({ right })} />
        )}
      </div>
      <TeachText label={t.wording} rows={2} value={draft.text} change={(text) => put({ text })} />
      {draft.ask === "choice" && (
        <>
          <TeachText
            label={t.choicesOffered}
            rows={5}
            value={draft.choices}
            change={(text) => put({ choices: text })}
          />
          <label className="teach-text">
            {t.rightChoice}
            <select
              className="select"
              value={Number(draft.right) < choices.length ? draft.right : ""}
              onChange={(event) => put({ right: event.currentTarget.value })}
            >
              {!(Number(draft.right) < choices.length) && <option value="">–</option>}
              {choices.map((choice, i) => (
                <option key={i} value={i}>
                  {choice}
                </option>
              ))}
            </select>
          </label>
        </>
      )}
      {languages.map((language) => (
        <Translated key={language} draft={draft} language={language} put={put} />
      ))}
      {truth && begun && <CorrectAnswer truth={truth} begun={begun} />}
    </section>
  );
}

/** Decimals of results of the run. */
const DECIMALS = 2;

/** The correct answer from the run; for a choice and a block the instructor enters it. */
function CorrectAnswer({ truth, begun }: { readonly truth: Truth; readonly begun: Answer }) {
  const t = useTexts("course-teach");
  const language = useSettings((s) => s.language);
  if (!hasAnswerInRun(truth, begun)) {
    return <Message tone="warning">{t.noTruth}</Message>;
  }
  if (truth.kind === "number")
    return <p className="small">{t.truth(formatNumber(language, truth.value ?? 0, DECIMALS))}</p>;
  if (truth.kind === "place" && truth.place)
    return <p className="small">{t.truth(t.place(...placeWords(language, truth.place)))}</p>;
  return null;
}
