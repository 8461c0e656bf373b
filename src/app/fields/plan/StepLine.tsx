import { Unbroken } from "../../base/Unbroken.tsx";
import type { PlanStep } from "../../../planning/working-plan.ts";
import { areaWords, cycleName, reasonWords, threadName, timeWords, type StepWords } from "./plan-words.ts";
import "./step-line.css";

interface Props {
  readonly words: StepWords;
  readonly step: Pick<PlanStep, "tried" | "seconds" | "why">;
  /** From 0. */
  readonly index: number;
}

/** An operation of a plan in one row: its number, what it is and why, its time with the tool change, and what it takes. */
export function StepLine({ words, step: { tried, seconds, why }, index }: Props) {
  const { t } = words,
    { action } = tried;
  return (
    <span className="step-line">
      <span className="step-number soft number">{index + 1}</span>
      <span className="step-what">
        <b>{t.kinds[action.kind]}</b>
        <span className="small soft">
          {cycleName(words, action.cycle)} · {t.steps.tool(String(action.tool.T), action.tool.NAME ?? "")}
        </span>
      </span>
      <span className="step-takes">
        <b className="number">{timeWords(words, seconds)}</b>
        <span className="small soft">
          {action.threads.length > 0
            ? action.threads.map(threadName).join(", ")
            : t.steps.takes(areaWords(words, tried.cut))}
        </span>
      </span>
      {why.length > 0 && (
        <span className="small step-why">
          <Unbroken text={why.map((reason) => reasonWords(words, reason, action)).join(" · ")} />
        </span>
      )}
    </span>
  );
}
