import { useState } from "react";
import type { PageQuestionWords } from "../../course/lesson.ts";
import { programOfQuestion } from "../../course/page-question.ts";
import { parameterValueIn, withParameterValue } from "../../course/playback-range.ts";
import { answerKindOf, typedPlace } from "../../course/predicted-answers.ts";
import { programOfLines } from "../../course/task-start.ts";
import { formatFixed } from "../../i18n/number.ts";
import type { Pt } from "../../kernel/geometry/point.ts";
import { radius, toDiameter } from "../../kernel/units.ts";
import { clock } from "../../app/base/clock.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { createPlaybackStore } from "../../app/calculation/playback-store.ts";
import { noteAnswer, useAnswerToQuestion, useLearning } from "../../app/records/course/progress.ts";
import { LessonPicture } from "./LessonPicture.tsx";
import { LessonProgram } from "./LessonProgram.tsx";
import { LessonQuestion, type Pressed } from "./LessonQuestion.tsx";
import { LessonSlide } from "./LessonSlide.tsx";
import { Paragraphs } from "./Paragraphs.tsx";
import type { LessonPageOf } from "./lesson-pages.ts";
import { StepLinks } from "./StepLinks.tsx";
import { useNextStep } from "./use-course-path.ts";
import { useLessonRun } from "./use-lesson-run.ts";

/** Decimals of a pointed place, mm. */
const POINTED = 1;

/** What was done on a page. */
interface Done {
  readonly slid?: number;
  readonly pressed?: Pressed;
  /** The question was answered correctly. */
  readonly isSolved?: boolean;
}
const NOTHING: Done = {};

/** On a page of a lesson that was read before, when its question is answered at last: what is next. */
function AfterReview({ lesson }: { readonly lesson: string }) {
  const step = useNextStep();
  const isRead = useLearning((s) => s.list.read.includes(lesson));
  if (!isRead || step === null || step.kind === "task") return null;
  return (
    <div className="course-ways">
      <StepLinks step={step} />
    </div>
  );
}

/** A page: its text next to the lathe, its slider and its question. */
export function PageOfLesson({
  lesson,
  page,
  text,
  questionWords,
  before,
  name,
}: {
  readonly lesson: string;
  readonly page: LessonPageOf;
  readonly text: string;
  readonly questionWords: PageQuestionWords | null;
  /** Texts of the pages before it. */
  readonly before: readonly string[];
  readonly name: string;
}) {
  const t = useTexts("course").picture;
  const language = useSettings((s) => s.language);
  const { slide, question, program } = page;
  const [playback] = useState(() => createPlaybackStore(clock));
  const [read, setRead] = useState(false);
  const [all, put] = useState<{ readonly key: string; readonly done: Done }>({ key: page.key, done: NOTHING });
  const done = all.key === page.key ? all.done : NOTHING;
  const note = (more: Done) =>
    put((now) => ({ key: page.key, done: { ...(now.key === page.key ? now.done : NOTHING), ...more } }));
  const first = slide ? (parameterValueIn(program, slide.q) ?? slide.from) : 0;
  const value = done.slid ?? first;
  const shownCase = done.isSolved && question?.with ? question : null;
  const slidLines = slide ? withParameterValue(program, slide.q, value) : program;
  const lines = shownCase ? programOfQuestion(shownCase, program) : slidLines;
  const shown = shownCase ? { ...page, key: `${page.key} ${shownCase.id}`, program: lines } : page;
  const { outcome, isPending, failed } = useLessonRun(programOfLines(lines));
  const asks = question && questionWords ? answerKindOf(question.asks) : null;
  const last = useAnswerToQuestion(lesson, question?.id ?? "");
  const press = ({ z, r }: Pt) =>
    note({
      pressed: {
        text: `${formatFixed(language, toDiameter(radius(Math.abs(r))), POINTED)} ${formatFixed(language, z, POINTED)}`,
      },
    });
  return (
    <>
      <div className="lesson-side">
        {outcome && (
          <LessonPicture
            outcome={outcome}
            page={shown}
            playback={playback}
            waits={isPending}
            failed={failed}
            slid={done.slid !== undefined}
            asked={
              asks === "place" && !done.isSolved
                ? { press, pressed: done.pressed ? typedPlace(done.pressed.text) : null }
                : null
            }
          />
        )}
        {!outcome && (
          <p className="lesson-waits soft" role="status">
            {failed ? t.failed : t.working}
          </p>
        )}
      </div>
      <div className="lesson-text">
        <section className="lesson-words" tabIndex={-1} aria-label={name} aria-live="polite" aria-atomic="true">
          <Paragraphs text={text} before={before} />
        </section>
        {slide && <LessonSlide slide={slide} value={value} lines={lines} onSlide={(next) => note({ slid: next })} />}
        {question && questionWords && (
          <LessonQuestion
            key={page.key}
            question={question}
            words={questionWords}
            lines={program}
            pressed={done.pressed ?? null}
            isAnswered={last?.last === "right"}
            onJudged={(isRight) => {
              noteAnswer(lesson, question.id, isRight);
              if (isRight) note({ isSolved: true });
            }}
          />
        )}
        {done.isSolved && last && last.answers > 1 && <AfterReview lesson={lesson} />}
        <LessonProgram
          lines={lines}
          playback={playback}
          open={read || asks === "block"}
          onOpen={setRead}
          run={isPending || !outcome ? null : outcome.run}
          onPress={asks === "block" ? (block) => note({ pressed: { text: String(block) } }) : null}
        />
      </div>
    </>
  );
}
