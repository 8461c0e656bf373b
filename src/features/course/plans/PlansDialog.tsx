import { useCallback, useMemo, useState } from "react";
import { createPortal } from "react-dom";
import { betterOf, type Achieved, type PlanComparison } from "../../../course/plans/plan-comparison.ts";
import type { Task } from "../../../course/task.ts";
import { USUAL_RULES } from "../../../planning/shop-rules.ts";
import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { ModalDialog } from "../../../app/base/ModalDialog.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { areaWords, timeWords } from "../../../app/fields/plan/plan-words.ts";
import { flushEdits } from "../../../app/document/store.ts";
import { presentProgram } from "../../../app/fields/compare/sides.ts";
import { goalText } from "../task/goal-words.ts";
import { PlanRowItem } from "./PlanRowItem.tsx";
import type { ComparisonWords } from "./plan-row-words.ts";
import { useComparison } from "./use-comparison.ts";
import "./plans.css";

/** Most goals that are named; of more only the number is given. */
const MOST_NAMED = 2;

interface Props {
  readonly task: Task;
  readonly t: CourseTaskTexts;
  readonly done: () => void;
}

/** The learner's plan beside the planner's, difference by difference. */
export function PlansDialog({ task, t, done }: Props) {
  const c = useTexts("plan-comparison"),
    plan = useTexts("plan"),
    work = useTexts(),
    language = useSettings((s) => s.language);
  const words: ComparisonWords = useMemo(() => ({ c, t: plan, work, language }), [c, plan, work, language]);
  const [text] = useState(() => {
    flushEdits();
    return presentProgram()?.text ?? "";
  });
  const { now, again } = useComparison(task, text);
  const goals = useCallback(
    (missed: Achieved["missed"]) => {
      const named = missed.slice(0, MOST_NAMED).map((goal) => goalText(t, work.page.effect.duration, language, goal));
      return [...named, ...(missed.length > MOST_NAMED ? [`+${missed.length - MOST_NAMED}`] : [])].join(" · ");
    },
    [t, work, language],
  );
  const status = (): string => {
    if (now.state === "done") return summary(words, now.comparison);
    if (now.state !== "running") return c[now.state];
    const { progress } = now;
    return progress?.kind === "trying" ? c.trying(progress.count) : c.planning(progress?.tries ?? 0);
  };
  return createPortal(
    <ModalDialog className="modal plans" title={c.title} done={done}>
      <p className="soft">{c.about}</p>
      <div className="plans-status" tabIndex={0}>
        <p role="status" aria-busy={now.state === "running"}>
          {status()}
        </p>
        {now.state === "running" && <progress aria-label={c.title} />}
        {now.state === "failed" && (
          <button type="button" className="button" onClick={again}>
            {c.again}
          </button>
        )}
      </div>
      {now.state === "done" && <Compared words={words} comparison={now.comparison} goals={goals} />}
    </ModalDialog>,
    document.body,
  );
}

/** How many differences were tried, and which way was better. */
function summary({ c }: ComparisonWords, { own, rows }: PlanComparison): string {
  if (own.operations.length === 0) return c.noProgram;
  const better = rows.flatMap(({ tried }) => tried.map((each) => betterOf(own.achieved, each)));
  const count = (which: "own" | "other") => better.filter((each) => each === which).length;
  return c.summary(better.length, count("other"), count("own"));
}

function Compared({
  words,
  comparison,
  goals,
}: {
  readonly words: ComparisonWords;
  readonly comparison: PlanComparison;
  readonly goals: (missed: Achieved["missed"]) => string;
}) {
  const { c } = words;
  const sides = [comparison.own.achieved, comparison.planned.achieved] as const;
  const facts: readonly (readonly [keyof typeof c.facts, (achieved: Achieved) => string])[] = [
    ["time", ({ seconds }) => timeWords(words, seconds)],
    ["changes", ({ changes }) => String(changes)],
    ["tools", ({ tools }) => tools.map((T) => `T${T}`).join(" ")],
    ["left", ({ left }) => areaWords(words, left)],
  ];
  return (
    <>
      <table className="plans-whole">
        <caption>{c.whole}</caption>
        <thead>
          <tr>
            <td />
            <th scope="col">{c.yours}</th>
            <th scope="col">{c.planner}</th>
          </tr>
        </thead>
        <tbody>
          {facts.map(([fact, say]) => (
            <tr key={fact}>
              <th scope="row">{c.facts[fact]}</th>
              {sides.map((achieved, i) => (
                <td key={i} className="number">
                  {say(achieved)}
                </td>
              ))}
            </tr>
          ))}
          <tr>
            <th scope="row">{c.facts.goals}</th>
            {sides.map(({ missed }, i) => (
              <td key={i} className={missed.length > 0 ? "plans-missed" : "plans-met"}>
                <Icon name={missed.length > 0 ? "warning" : "check"} />{" "}
                {missed.length > 0 ? c.missed(goals(missed)) : c.met}
              </td>
            ))}
          </tr>
        </tbody>
      </table>
      <p className="small soft">{c.withChanges(timeWords(words, USUAL_RULES.toolChange))}</p>
      <h3>{c.rows}</h3>
      <ol className="plans-rows" aria-label={c.rows}>
        {comparison.rows.map((row, i) => (
          <PlanRowItem key={i} words={words} comparison={comparison} row={row} goals={goals} />
        ))}
      </ol>
    </>
  );
}
