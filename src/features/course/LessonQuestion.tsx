import { Suspense, useEffect, useEffectEvent, useId, useRef, useState } from "react";
import type { PageQuestion, PageQuestionWords } from "../../course/lesson.ts";
import { answerKindOf } from "../../course/predicted-answers.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { Unbroken } from "../../app/base/Unbroken.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { AskedAnswer } from "./task/AskedAnswer.tsx";
import { Paragraphs } from "./Paragraphs.tsx";
import { usePageAnswer, type PageAnswer } from "./use-page-answer.ts";
import "./lesson-question.css";

/** A place or a block that was pressed on the page; a new object for each press. */
export interface Pressed {
  readonly text: string;
}

/** The answers of a choice: pressing one answers. A wrong one stays marked, and the others remain to be tried. */
function Choices({
  choices,
  labelled,
  given,
  right,
  onAnswer,
}: {
  readonly choices: readonly string[];
  readonly labelled: string;
  readonly given: PageAnswer | null;
  readonly right: number;
  readonly onAnswer: (text: string) => void;
}) {
  const [tried, add] = useState<readonly number[]>([]);
  return (
    <div className="lesson-answers" role="group" aria-labelledby={labelled}>
      {choices.map((choice, i) => {
        const state = tried.includes(i) ? (i === right ? "right" : "wrong") : undefined;
        return (
          <button
            key={i}
            type="button"
            className="button lesson-answer"
            data-state={state}
            aria-pressed={given?.text === String(i)}
            onClick={() => {
              add([...tried, i]);
              onAnswer(String(i));
            }}
          >
            <span className="lesson-answer-mark">{state && <Icon name={state === "right" ? "check" : "close"} />}</span>
            <span>
              <Unbroken text={choice} />
            </span>
          </button>
        );
      })}
    </div>
  );
}

/** The field of a number, a place or a block. Pressing a place or a block answers at once. */
function TypedAnswer({
  question,
  labelled,
  pressed,
  given,
  onAnswer,
  onType,
}: {
  readonly question: PageQuestion;
  readonly labelled: string;
  readonly pressed: Pressed | null;
  readonly given: PageAnswer | null;
  readonly onAnswer: (text: string) => void;
  readonly onType: () => void;
}) {
  const t = useTexts("course-task");
  const check = useTexts("course").question.check;
  const [typed, type] = useState<{ readonly text: string; readonly by: Pressed | null }>({ text: "", by: null });
  const text = pressed && pressed !== typed.by ? pressed.text : typed.text;
  return (
    <form
      className="lesson-typed"
      onSubmit={(event) => {
        event.preventDefault();
        onAnswer(text);
      }}
    >
      <AskedAnswer
        prediction={question.asks}
        put={(next) => {
          type({ text: next, by: pressed });
          if (given) onType();
        }}
        text={text}
        choices={[]}
        t={t}
        labelled={labelled}
      />
      <button type="submit" className="button">
        {check}
      </button>
    </form>
  );
}

/** The result of the last answer, with its reason. */
function Reason({
  given,
  words,
  isShown,
}: {
  readonly given: PageAnswer | null;
  readonly words: PageQuestionWords;
  /** The picture shows the case of the question. */
  readonly isShown: boolean;
}) {
  const t = useTexts("course").question;
  const judged = given?.judged;
  const isJudged = judged !== null && typeof judged === "object";
  const place = useRef<HTMLDivElement>(null);
  // On a small screen the reason would appear below the fold.
  useEffect(() => {
    if (judged) place.current?.scrollIntoView({ block: "nearest" });
  }, [judged]);
  return (
    <div ref={place} className="lesson-reason" role="status" data-right={isJudged ? judged.right : undefined}>
      {given && judged === null && t.checking}
      {judged === "failed" && t.failed}
      {judged === "unreadable" && t.lacks}
      {isJudged && (
        <>
          <b>
            <Icon name={judged.right ? "check" : "close"} /> {judged.right ? t.right : t.wrong}
          </b>
          <Paragraphs
            text={[judged.slip && t[judged.slip], words.why[judged.why], judged.right && isShown && t.shown]
              .filter((each) => each !== null && each !== undefined && each !== false)
              .join(" ")}
          />
        </>
      )}
    </div>
  );
}

/**
 * The question of a page. Each answer gets its reason at once, wrong ones can be tried again, and nothing depends on
 * it.
 */
export function LessonQuestion({
  question,
  words,
  lines,
  pressed,
  isAnswered,
  onJudged,
}: {
  readonly question: PageQuestion;
  readonly words: PageQuestionWords;
  readonly lines: readonly string[];
  readonly pressed: Pressed | null;
  /** It was answered correctly, now or before. */
  readonly isAnswered: boolean;
  readonly onJudged: (isRight: boolean) => void;
}) {
  const t = useTexts("course").question;
  const labelled = useId();
  const { given, answer, clear } = usePageAnswer(question, lines, onJudged);
  const onPress = useEffectEvent((text: string) => answer(text));
  useEffect(() => {
    if (pressed) onPress(pressed.text);
  }, [pressed]);
  const { asks } = question;
  return (
    <section className="lesson-question" aria-label={t.name} tabIndex={-1}>
      <div id={labelled} className="lesson-ask">
        <b>
          <Unbroken text={words.ask} />
        </b>
        {isAnswered && (
          <span className="lesson-answered" role="img" aria-label={t.answered} title={t.answered}>
            <Icon name="check" />
          </span>
        )}
      </div>
      {answerKindOf(asks) === "choice" && asks.ask === "choice" ? (
        <Choices choices={words.choices ?? []} labelled={labelled} given={given} right={asks.right} onAnswer={answer} />
      ) : (
        <Suspense>
          <TypedAnswer
            question={question}
            labelled={labelled}
            pressed={pressed}
            given={given}
            onAnswer={answer}
            onType={clear}
          />
        </Suspense>
      )}
      <Reason given={given} words={words} isShown={question.with !== undefined} />
    </section>
  );
}
