import { Suspense, useId, useState } from "react";
import { checkIn, checksLeft, type Exam } from "../../../course/exam.ts";
import { goalsOf } from "../../../course/goals.ts";
import type { Task } from "../../../course/task.ts";
import { inScreenLanguage } from "../../../course/words.ts";
import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import { calculation } from "../../../app/calculation/calculation.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts, useTextsOrNull } from "../../../app/base/settings/use-texts.ts";
import { useMedia } from "../../../app/base/use-media.ts";
import { openText } from "../../../app/document/printed.ts";
import { flushEdits, useEditor } from "../../../app/document/store.ts";
import { changeTask, taskOfWork } from "../../../app/document/work-task.ts";
import { noteExamCheck } from "../../../app/records/course/exams.ts";
import { DrawingPane } from "../drawing/DrawingPane.tsx";
import { WorkshopDrawing } from "../drawing/WorkshopDrawing.tsx";
import { Paragraphs } from "../Paragraphs.tsx";
import { examCheckHere } from "../teach/hand-in.ts";
import { goalText } from "./goal-words.ts";
import { DrawingButton } from "./DrawingButton.tsx";
import { FoldButton } from "./FoldButton.tsx";
import { PredictForm } from "./PredictForm.tsx";
import { useTaskDrawing } from "./use-task-drawing.ts";
import { useTaskView } from "./task-view.ts";

const NOTHING: readonly string[] = [];

interface Props {
  readonly task: Task;
  readonly exam: Exam;
  readonly t: CourseTaskTexts;
}

/** The assignment, the drawing and the goals, without ticks: an exam says no more than its instructor chose. */
function Assignment({ task, t, ask }: Omit<Props, "exam"> & { readonly ask: string }) {
  const language = useSettings((s) => s.language);
  const { duration } = useTexts("first").page.effect;
  // Where the assignment takes the place of the work, the drawing is part of it.
  const isAlone = useMedia("narrow");
  return (
    <>
      <section className="task-part task-ask" aria-label={t.unfold}>
        <Paragraphs text={ask} before={NOTHING} />
        {task.part && isAlone && (
          <details className="task-drawing" open>
            <summary>{t.drawing}</summary>
            <WorkshopDrawing task={task} language={language} />
          </details>
        )}
      </section>
      {task.kind !== "predict" && (
        <section className="task-part" aria-label={t.goals}>
          <h3>{t.goals}</h3>
          <ul className="set-terms">
            {goalsOf(task).map((goal, i) => (
              <li key={i}>{goalText(t, duration, language, goal)}</li>
            ))}
          </ul>
        </section>
      )}
    </>
  );
}

/** Checks the open work and counts it; false if nothing cuts yet, which is no try. */
async function check(task: Task): Promise<boolean> {
  flushEdits();
  const text = openText();
  const found = text === null ? null : await examCheckHere(task, text);
  if (found) noteExamCheck(task.id, found);
  return found !== null;
}

/** A task of an exam above its work: no hints, no solution, and as much after a check as the instructor chose. */
export function ExamPanel({ task, exam, t }: Props) {
  const words = useTextsOrNull("course-set");
  const language = useSettings((s) => s.language);
  const body = useId();
  const said = inScreenLanguage(task.words, language);
  const veiled = useEditor((s) => taskOfWork(s)?.veiled ?? false);
  const { open } = useTaskView();
  const alone = useMedia("narrow") && open;
  const drawing = useTaskDrawing(task);
  const [state, go] = useState<"checking" | "noRun" | "answered" | null>(null);
  if (!said || !words) return null;
  const { ended, set } = exam;
  const reports = set.exam?.reports ?? "nothing";
  const last = checkIn(exam, task.id),
    left = checksLeft(exam, task.id);
  const canCheck = reports !== "nothing" && task.kind !== "predict" && !veiled && !ended;
  const status = () => {
    if (ended) return words.exam.over;
    if (state === "checking") return t.checking;
    if (state === "noRun") return t.noRun;
    if (state === "answered") return words.exam.answered;
    if (!last || reports === "nothing") return words.exam.noReport;
    if (last.passed) return t.passed;
    return reports === "goals" ? words.exam.met(last.met, last.of) : words.exam.notPassed;
  };
  const finish =
    task.kind === "predict"
      ? { label: words.exam.saveAnswers, act: () => go("answered") }
      : {
          label: t.predict.run,
          act: () => {
            changeTask(({ veiled: _, ...rest }) => rest);
            calculation.recalculate();
          },
        };
  return (
    <section
      className="task-panel"
      role={alone ? "main" : undefined}
      aria-label={t.region(said.title)}
      data-open={open}
      data-veiled={veiled}
      onKeyDown={(event) => event.stopPropagation()}
    >
      <div className="task-head">
        <h2 className="task-title">{said.title}</h2>
        <p className="task-status" role="status" lang={language}>
          <span>{status()}</span>
        </p>
        <DrawingButton drawing={drawing} t={t} />
        <FoldButton body={body} t={t} />
        {canCheck && (
          <button
            type="button"
            className="button primary"
            aria-disabled={state === "checking" || left === 0}
            onClick={() => {
              if (state === "checking" || left === 0) return;
              go("checking");
              void check(task).then((isCounted) => go(isCounted ? null : "noRun"));
            }}
          >
            <Icon name="check" /> {left === null ? t.check : words.exam.checkLeft(left)}
          </button>
        )}
      </div>
      <div id={body} className="task-body" hidden={!open}>
        {open && (
          <Suspense>
            <Assignment task={task} t={t} ask={said.ask} />
          </Suspense>
        )}
      </div>
      {veiled && <PredictForm task={task} t={t} words={said} finish={finish} />}
      {drawing.shown && (
        <Suspense>
          <DrawingPane task={task} />
        </Suspense>
      )}
    </section>
  );
}
