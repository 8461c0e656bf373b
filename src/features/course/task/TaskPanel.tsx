import { Suspense, useCallback, useEffect, useId, useMemo, useRef } from "react";
import type { TaskMark } from "../../../course/judge/judgement.ts";
import type { Task } from "../../../course/task.ts";
import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import { useOutcome } from "../../../app/calculation/outcome.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { FIRST_FOCUS } from "../../../app/base/focus-guard.ts";
import { KEEPS_KEYBOARD, usePlace } from "../../../app/place/place.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { useEditor } from "../../../app/document/store.ts";
import { useMedia } from "../../../app/base/use-media.ts";
import { inScreenLanguage } from "../../../course/words.ts";
import { DrawingPane } from "../drawing/DrawingPane.tsx";
import { checkTask, isOfWork, judgeQuietly, clearResolvedNotReady } from "./check.ts";
import { comparePredictions } from "./predict.ts";
import { TaskPlace } from "./TaskPlace.tsx";
import { useFindingsOfTask } from "./use-task-result.ts";
import { withNumbers } from "../../../course/varied-numbers.ts";
import { DrawingButton } from "./DrawingButton.tsx";
import { FoldButton } from "./FoldButton.tsx";
import { PredictForm } from "./PredictForm.tsx";
import { PredictionResult } from "./PredictionResult.tsx";
import { MarkLine } from "./MarkLine.tsx";
import { markText } from "./mark-words.ts";
import { TaskBody } from "./TaskBody.tsx";
import { PassedLine } from "./TaskOnward.tsx";
import { TaskStatus, usePassedNow } from "./TaskStatus.tsx";
import { useTaskPicture } from "./use-task-picture.ts";
import { useTaskDrawing } from "./use-task-drawing.ts";
import { useTaskView } from "./task-view.ts";
import { taskOfWork } from "../../../app/document/work-task.ts";

/** Debounce after a result before the goals are judged again, ms. */
const QUIET = 400;

/** After the first check the goals update in the background; marks of a stale check are removed from the picture. */
function useLiveJudgement(task: Task): void {
  const newest = useOutcome((s) => s.newest);
  const job = useEditor((s) => s.job);
  const program = useEditor((s) => s.program);
  const checked = useTaskView((v) => v.checked);
  const section = usePlace((p) => p.section);
  const prompt = usePlace((p) => p.prompt);
  // Not while a value is typed: targets must not move away.
  useEffect(clearResolvedNotReady, [section, prompt]);
  useEffect(() => {
    if (!checked) return undefined;
    const stale = !isOfWork(checked.answer as NonNullable<typeof newest>);
    if (useTaskView.getState().stale !== stale)
      useTaskView.setState({ stale, ...(!stale && { live: checked.judgement }) });
    if (!stale) return undefined;
    const timer = setTimeout(() => judgeQuietly(task), QUIET);
    return () => clearTimeout(timer);
  }, [task, newest, job, program, checked]);
}

/** After a check, the focus goes to its first place, unless the operator has moved it. */
const focusResult = (check: HTMLElement): number =>
  requestAnimationFrame(() => {
    if (document.activeElement !== check) return;
    check.closest("section")?.querySelector<HTMLElement>(`[${FIRST_FOCUS}]`)?.focus({ preventScroll: true });
  });

/** A task above its work: one line with the next step, and the unfolded assignment. */
export function TaskPanel({ task, t }: { readonly task: Task; readonly t: CourseTaskTexts }) {
  const texts = useTexts();
  const language = useSettings((s) => s.language);
  const body = useId();
  const varied = useEditor((s) => taskOfWork(s)?.varied);
  const words = useMemo(() => inScreenLanguage(withNumbers(task, varied).words, language), [task, varied, language]);
  const veiled = useEditor((s) => taskOfWork(s)?.veiled ?? false);
  const { open, checking, checked, comparedAnswers, stale } = useTaskView();
  const marks = useMemo(() => checked?.judgement.marks.filter((mark) => !mark.passed) ?? null, [checked]);
  const say = useCallback(
    (mark: TaskMark) => (checked ? markText(mark, { t, texts, language, task, answer: checked.answer }) : ""),
    [checked, t, texts, language, task],
  );
  const passed = usePassedNow(task);
  const drawing = useTaskDrawing(task);
  useLiveJudgement(task);
  useTaskPicture(task, t, language, marks, say);
  useFindingsOfTask(task, t, marks, say);
  /** With little room, the assignment replaces the work. */
  const alone = useMedia("narrow") && open;
  const wasAlone = useRef(alone);
  useEffect(() => {
    // Where the page scrolls, the work would begin below the line of the task.
    if (wasAlone.current && !alone) document.getElementById("prompts")?.scrollIntoView?.({ block: "start" });
    wasAlone.current = alone;
  }, [alone]);
  const asks = task.predict !== undefined && task.predict.length > 0;
  useEffect(() => {
    if (asks && !veiled) void comparePredictions(task);
  }, [task, asks, veiled]);
  if (!words) return null;
  const makes = task.kind !== "predict";
  return (
    <section
      className="task-panel"
      role={alone ? "main" : undefined}
      aria-label={t.region(words.title)}
      data-open={open}
      data-veiled={veiled}
      onKeyDown={(event) => event.stopPropagation()}
      {...{ [KEEPS_KEYBOARD]: "" }}
    >
      <div className="task-head">
        <h2 className="task-title">{words.title}</h2>
        <Suspense>
          <TaskPlace task={task} t={t} />
        </Suspense>
        <TaskStatus task={task} t={t} />
        <DrawingButton drawing={drawing} t={t} />
        <FoldButton body={body} t={t} />
        {/* Last: its result, and the way on, follow in the order of Tab. */}
        {makes && !veiled && (
          <button
            type="button"
            className="button primary"
            aria-disabled={checking}
            onClick={({ currentTarget }) => !checking && void checkTask(task).then(() => focusResult(currentTarget))}
          >
            <Icon name="check" /> {t.check}
          </button>
        )}
      </div>
      {!open && !veiled && comparedAnswers && !marks?.length && !(passed && makes) && (
        <PredictionResult task={task} t={t} words={words} />
      )}
      {checked && marks && marks.length > 0 && !stale && (
        <MarkLine marks={marks} say={say} run={checked.answer.run} t={t} />
      )}
      {!open && passed && (
        <Suspense>
          <PassedLine task={task} t={t} words={words} />
        </Suspense>
      )}
      <div id={body} className="task-body" hidden={!open}>
        {open && (
          <Suspense>
            <TaskBody task={task} t={t} words={words} />
          </Suspense>
        )}
      </div>
      {veiled && <PredictForm task={task} t={t} words={words} />}
      {drawing.shown && (
        <Suspense>
          <DrawingPane task={task} />
        </Suspense>
      )}
    </section>
  );
}
