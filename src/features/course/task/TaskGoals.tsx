import type { ReactNode } from "react";
import { groupGoals, goalsOf, isMet, marksOn, type DrawnGoal, type TaskGoal } from "../../../course/goals.ts";
import type { TaskMark } from "../../../course/judge/judgement.ts";
import type { Task } from "../../../course/task.ts";
import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useMedia } from "../../../app/base/use-media.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { goalText } from "./goal-words.ts";
import { placedText } from "./mark-words.ts";
import { showTaskMark } from "./show-mark.ts";
import { useTaskView } from "./task-view.ts";

interface Props {
  readonly task: Task;
  readonly t: CourseTaskTexts;
}

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

/** A goal that is not met leads to its place: in the picture, and to the block or prompt. */
function GoalText({
  mark,
  t,
  children,
}: Pick<Props, "t"> & { readonly mark: TaskMark | null; readonly children: string }) {
  const isNarrow = useMedia("narrow");
  if (!mark) return children;
  return (
    <button
      type="button"
      className="task-goal"
      title={t.showPlace}
      onClick={() => {
        // The assignment covers the work.
        if (isNarrow) useTaskView.setState({ open: false });
        showTaskMark(mark);
      }}
    >
      {children}
    </button>
  );
}

/** The first mark of a goal that has a place to show. */
const placedMark = (marks: readonly TaskMark[]): TaskMark | null =>
  marks.find(({ place, block, step }) => place !== undefined || block !== undefined || step !== undefined) ?? null;

/** The sizes on the drawing as one goal; unfolded, each size, wrong ones first, with its measured value and place. */
function DrawnSizes({
  task,
  t,
  drawn,
  known,
}: Props & { readonly drawn: readonly DrawnGoal[]; readonly known: boolean }) {
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
                <GoalText mark={placedMark(marks)} t={t}>
                  {goalText(t, duration, language, goal)}
                </GoalText>
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
export function TaskGoals({ task, t, hasDrawing }: Props & { readonly hasDrawing: boolean }) {
  const language = useSettings((s) => s.language);
  const { duration } = useTexts("first").page.effect;
  const { live, comparedAnswers } = useTaskView();
  const rights = (comparedAnswers ?? []).map(({ right }) => right);
  const all = goalsOf(task),
    groups = groupGoals(all, live);
  const isGathered = hasDrawing && groups.drawn.length > 1;
  const row = (goal: TaskGoal, i: number) => {
    const known = goal.kind === "predicted" ? comparedAnswers !== null : live !== null;
    const met = known ? isMet(goal, live, rights) : undefined;
    return (
      <li key={`${goal.kind} ${i}`} data-met={met}>
        <Ticked met={met} t={t}>
          <GoalText mark={met === false ? placedMark(marksOn(goal, live)) : null} t={t}>
            {goalText(t, duration, language, goal)}
          </GoalText>
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
