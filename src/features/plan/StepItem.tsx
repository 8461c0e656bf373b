import { useId } from "react";
import type { PlanStep } from "../../planning/working-plan.ts";
import type { Clamping, StoredPart } from "../../app/records/part-store.ts";
import { exclude, setValues, takeWay, toggleLock } from "./plan-store.ts";
import { StepValues } from "./StepValues.tsx";
import { openStep, pointAtStep } from "./plan-place.ts";
import type { HandValues } from "../../planning/types.ts";
import type { ValuesTried } from "../../app/calculation/part-plan.ts";
import { Unbroken } from "../../app/base/Unbroken.tsx";
import { StepLine } from "../../app/fields/plan/StepLine.tsx";
import {
  actionWords,
  cycleName,
  differenceWords,
  timeWords,
  type PlanWords,
} from "../../app/fields/plan/plan-words.ts";

interface Props {
  readonly words: PlanWords;
  readonly stored: StoredPart;
  readonly step: PlanStep;
  readonly index: number;
  readonly isOpen: boolean;
  readonly isLocked: boolean;
  readonly clamping: Clamping;
  /** False while a plan is searched, or for an outdated one: nothing can be changed then. */
  readonly canChange: boolean;
  /** What the operation does with other values. */
  readonly preview: (values: HandValues) => Promise<ValuesTried | null>;
}

/** One operation of a plan: what it is, what it takes; open, why, its values and the next best ways. */
export function StepItem({ words, stored, step, index, isOpen, isLocked, clamping, canChange, preview }: Props) {
  const { t } = words,
    { steps: w } = t,
    id = useId();
  const { tried, others, penalty } = step;
  const { action } = tried;
  const tool = w.tool(String(action.tool.T), action.tool.NAME ?? "");
  return (
    <li
      className={`plan-step${isOpen ? " open" : ""}`}
      onPointerEnter={() => pointAtStep(index)}
      onPointerLeave={() => pointAtStep(null)}
    >
      <div className="plan-step-head">
        <button
          type="button"
          className="plan-step-name"
          aria-expanded={isOpen}
          aria-controls={id}
          onFocus={() => pointAtStep(index)}
          onBlur={() => pointAtStep(null)}
          onClick={() => openStep(index)}
        >
          <StepLine words={words} step={step} index={index} />
        </button>
        <button
          type="button"
          className="button icon plain"
          aria-pressed={isLocked}
          aria-label={w.lock(index + 1)}
          title={w.lock(index + 1)}
          onClick={() => toggleLock(clamping, action.key)}
        >
          <svg className="icon" viewBox="0 0 24 24" aria-hidden="true" focusable="false">
            <path d={`M6 11h12v9H6zM8.5 11V7.5a3.5 3.5 0 0 1 7 0${isLocked ? "V11" : ""}`} />
          </svg>
        </button>
      </div>
      {isOpen && (
        <div className="plan-step-more" id={id}>
          {penalty > 0 && <p className="small soft">{w.penalty(timeWords(words, penalty))}</p>}
          <StepValues
            key={action.key}
            words={words}
            step={step}
            index={index}
            canChange={canChange}
            preview={preview}
            onSet={(values) => setValues(clamping, index, action.key, values)}
          />
          <h2>{w.others}</h2>
          {others.length === 0 && <p className="small soft">{w.noOther}</p>}
          {others.length > 0 && (
            <ul className="plan-others">
              {others.map((other) => {
                const { action: way } = other.tried,
                  name = actionWords(words, way);
                return (
                  <li key={way.key}>
                    <b>{cycleName(words, way.cycle)}</b>
                    <span className="small">{w.tool(String(way.tool.T), way.tool.NAME ?? "")}</span>
                    <span className="small number">{timeWords(words, other.seconds)}</span>
                    <span className="small">
                      <Unbroken text={differenceWords(words, other)} />
                    </span>
                    <button
                      type="button"
                      className="button small"
                      disabled={!canChange}
                      aria-label={w.useLong(index + 1, name)}
                      onClick={() => takeWay(clamping, index, action.key, way.key)}
                    >
                      {w.use}
                    </button>
                  </li>
                );
              })}
            </ul>
          )}
          <div className="plan-step-ways">
            <button
              type="button"
              className="button small"
              disabled={!canChange}
              onClick={() => exclude({ withoutTools: [...stored.withoutTools, action.tool.T] })}
            >
              {w.exclude(tool)}
            </button>
            {action.cycle !== null && (
              <button
                type="button"
                className="button small"
                disabled={!canChange}
                onClick={() =>
                  action.cycle !== null && exclude({ withoutCycles: [...stored.withoutCycles, action.cycle] })
                }
              >
                {w.forbid(String(action.cycle))}
              </button>
            )}
          </div>
        </div>
      )}
    </li>
  );
}
