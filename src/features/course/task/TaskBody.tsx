import type { ReactNode } from "react";
import { groupGoals, goalsOf, isMet, type DrawnGoal, type TaskGoal } from "../../../course/goals.ts";
import type { Task, TaskWords } from "../../../course/task.ts";
import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import { formatNumber } from "../../../i18n/number.ts";
import { writer } from "../../../i18n/write.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { useEditor } from "../../../app/document/store.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { WorkshopDrawing } from "../drawing/WorkshopDrawing.tsx";
import { Paragraphs } from "../Paragraphs.tsx";
import { PredictionResult } from "./PredictionResult.tsx";
import { useMedia } from "../../../app/base/use-media.ts";
import { durationText } from "../../../app/base/clock-text.ts";
import { goalText } from "./goal-words.ts";
import { placedText } from "./mark-words.ts";
import { TaskHelp } from "./TaskHelp.tsx";
import { TaskOnward } from "./TaskOnward.tsx";
import { useTaskView } from "./task-view.ts";
import { useIsDrawn } from "./use-task-drawing.ts";
import { taskOfWork } from "../../../app/document/work-task.ts";

interface Props {
  readonly task: Task;
  readonly t: CourseTaskTexts;
  readonly words: TaskWords;
}

/** A task may be the first page of the course that is read: no glossary term was introduced before. */
const NOTHING: readonly string[] = [];

/** One goal with its tick; `met`: undefined while unknown. */
function Ticked({
  met,
  t,
  children,
}: {
  readonly met: boolean | undefined;
  readonly t: CourseTaskTexts;
  readonly children: ReactNode;
}) {
  return (
    <>
      <span className="task-tick" aria-hidden="true">
        {met !== undefined && <Icon name={met ? "check" : "close"} />}
      </span>
      <span>
        {children} {met !== undefined && <span className="unseen">, {met ? t.met : t.notMet}</span>}
      </span>
    </>
  );
}

/** The sizes on the drawing as one goal; unfolded, each size, wrong ones first, with its measured value and place. */
function DrawnSizes({
  task,
  t,
  drawn,
  known,
}: Omit<Props, "words"> & { readonly drawn: readonly DrawnGoal[]; readonly known: boolean }) {
  const language = useSettings((s) => s.language);
  const { duration } = useTexts("first").page.effect;
  const wrong = drawn.filter(({ marks }) => marks.length > 0).length;
  const met = known ? wrong === 0 : undefined;
  return (
    <li className="task-drawn" data-met={met}>
      <details>
        <summary>
          <Ticked met={met} t={t}>
            {wrong > 0 ? t.is.drawnWrong(drawn.length, wrong) : t.is.drawn(drawn.length)}
          </Ticked>
        </summary>
        <ul>
          {drawn.map(({ goal, marks }, i) => (
            <li key={i} data-met={known ? marks.length === 0 : undefined}>
              <Ticked met={known ? marks.length === 0 : undefined} t={t}>
                {goalText(t, duration, language, goal)}
                {marks.map((mark, k) => (
                  <span key={k} className="task-measured">
                    {placedText(mark, { t, language, task })}
                  </span>
                ))}
              </Ticked>
            </li>
          ))}
        </ul>
      </details>
    </li>
  );
}

/** The goals of the task, ticked after the first check. The sizes on a drawing are one goal. */
function Goals({ task, t, hasDrawing }: Omit<Props, "words"> & { readonly hasDrawing: boolean }) {
  const language = useSettings((s) => s.language);
  const { duration } = useTexts("first").page.effect;
  const { live, comparedAnswers } = useTaskView();
  const rights = (comparedAnswers ?? []).map(({ right }) => right);
  const all = goalsOf(task),
    groups = groupGoals(all, live);
  const isGathered = hasDrawing && groups.drawn.length > 1;
  const row = (goal: TaskGoal, i: number) => {
    const known = goal.kind === "foretold" ? comparedAnswers !== null : live !== null;
    const met = known ? isMet(goal, live, rights) : undefined;
    return (
      <li key={`${goal.kind} ${i}`} data-met={met}>
        <Ticked met={met} t={t}>
          {goalText(t, duration, language, goal)}
        </Ticked>
      </li>
    );
  };
  return (
    <section className="task-part" aria-label={t.goals}>
      <h3>{t.goals}</h3>
      <ul className="task-goals">
        {(isGathered ? groups.before : all).map(row)}
        {isGathered && <DrawnSizes task={task} t={t} drawn={groups.drawn} known={live !== null} />}
        {isGathered && groups.after.map((goal, i) => row(goal, all.length + i))}
      </ul>
    </section>
  );
}

/** The score of a drawing task, and how to improve it. */
function Scored({ t }: Pick<Props, "t">) {
  const language = useSettings((s) => s.language);
  const { duration } = useTexts("first").page.effect;
  const score = useTaskView((v) => v.checked?.judgement.score);
  if (!score) return null;
  const write = writer(language);
  return (
    <section className="task-part" aria-label={t.score.title}>
      <h3>{t.score.of(String(score.total))}</h3>
      <ul className="task-score">
        {score.parts.map(({ what, points, of, value, par }) => {
          const number = (each: number) => {
            if (what === "time") return durationText(duration, language, each);
            return what === "residue" ? write.area(each) : formatNumber(language, each, 0);
          };
          return (
            <li key={what}>
              <span>{t.score.parts[what]}</span>{" "}
              <meter min={0} max={of} value={points} aria-label={t.score.parts[what]} />{" "}
              <span className="number">
                {points}/{of}
              </span>
              {points < of && <span className="soft small">{t.score.better[what](number(value), number(par))}</span>}
            </li>
          );
        })}
      </ul>
    </section>
  );
}

/** Assignment, goals, help step by step, and the next task. */
export function TaskBody({ task, t, words }: Props) {
  const language = useSettings((s) => s.language);
  const veiled = useEditor((s) => taskOfWork(s)?.veiled ?? false);
  const isDrawn = useIsDrawn(task);
  // Where the assignment takes the place of the work, the drawing is part of it.
  const isAlone = useMedia("narrow");
  return (
    <>
      <section className="task-part task-ask" aria-label={t.unfold}>
        <Paragraphs text={words.ask} before={NOTHING} />
        {isDrawn && isAlone && (
          <details className="task-drawing" open>
            <summary>{t.drawing}</summary>
            <WorkshopDrawing task={task} language={language} />
          </details>
        )}
      </section>
      <div className="task-beside">
        <Goals task={task} t={t} hasDrawing={isDrawn} />
        <Scored t={t} />
        {!veiled && <PredictionResult t={t} words={words} />}
      </div>
      <div className="task-beside">
        <TaskHelp task={task} t={t} words={words} />
        <TaskOnward task={task} t={t} words={words} />
      </div>
    </>
  );
}
