import { useId } from "react";
import type { PlanStep } from "../../planning/working-plan.ts";
import type { StoredPart } from "../../app/records/part-store.ts";
import { exclude, takeWay, toggleLock } from "./plan-store.ts";
import { openStep, pointAtStep } from "./plan-place.ts";
import {
  actionWords,
  areaWords,
  cycleWords,
  reasonWords,
  timeWords,
  valueWords,
} from "../../app/calculation/plan-step-words.ts";
import { threadName, type PlanWords } from "./plan-words.ts";

interface Props {
  readonly words: PlanWords;
  readonly stored: StoredPart;
  readonly step: PlanStep;
  readonly index: number;
  readonly isOpen: boolean;
  readonly isLocked: boolean;
  /** The second clamping follows from the first: its operations are shown only. */
  readonly isSecond: boolean;
  /** False while a plan is searched, or for an outdated one: nothing can be changed then. */
  readonly canChange: boolean;
}

/** Less is the same, mm² and s. */
const SAME_AREA = 0.05,
  SAME_TIME = 0.05;

/** One operation of a plan: what it is, what it takes; open, why, its values and the next best ways. */
export function StepItem({ words, stored, step, index, isOpen, isLocked, isSecond, canChange }: Props) {
  const { t } = words,
    { steps: w } = t,
    id = useId();
  const { tried, others, why, seconds, penalty } = step;
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
          <span className="plan-step-number number">{index + 1}</span>
          <span className="plan-step-what">
            <b>{t.kinds[action.kind]}</b>
            <span className="small soft">
              {cycleWords(words, action.cycle)} · {tool}
            </span>
            {why.length > 0 && (
              <span className="small plan-step-why">{why.map((reason) => reasonWords(words, reason)).join(" · ")}</span>
            )}
          </span>
          <span className="plan-step-takes">
            <b className="number">{timeWords(words, seconds)}</b>
            <span className="small soft">
              {action.threads.length > 0
                ? action.threads.map(threadName).join(", ")
                : w.takes(areaWords(words, tried.cut))}
            </span>
          </span>
        </button>
        {!isSecond && (
          <button
            type="button"
            className="button icon plain"
            aria-pressed={isLocked}
            aria-label={w.lock(index + 1)}
            title={w.lock(index + 1)}
            onClick={() => toggleLock(stored.id, action)}
          >
            <svg className="icon" viewBox="0 0 24 24" aria-hidden="true" focusable="false">
              <path d={`M6 11h12v9H6zM8.5 11V7.5a3.5 3.5 0 0 1 7 0${isLocked ? "V11" : ""}`} />
            </svg>
          </button>
        )}
      </div>
      {isOpen && (
        <div className="plan-step-more" id={id}>
          {penalty > 0 && <p className="small soft">{w.penalty(timeWords(words, penalty))}</p>}
          {action.values.length > 0 && (
            <table className="plan-values">
              <caption>{w.values}</caption>
              <tbody>
                {action.values.map((each) => {
                  const said = valueWords(words, action.cycle, each);
                  return (
                    <tr key={each.q}>
                      <th scope="row" className="number">
                        {said.name} <span className="soft small">{said.label}</span>
                      </th>
                      <td className="number">{said.value}</td>
                      <td className="small soft">{said.formula}</td>
                    </tr>
                  );
                })}
              </tbody>
            </table>
          )}
          <h2>{w.others}</h2>
          {others.length === 0 && <p className="small soft">{w.noOther}</p>}
          {others.length > 0 && (
            <ul className="plan-others">
              {others.map((other) => {
                const { action: way } = other.tried,
                  name = actionWords(words, way);
                return (
                  <li key={way.key}>
                    <b>{cycleWords(words, way.cycle)}</b>
                    <span className="small">{w.tool(String(way.tool.T), way.tool.NAME ?? "")}</span>
                    <span className="small number">
                      {timeWords(words, other.seconds)}
                      {Math.abs(other.longer) > SAME_TIME && (
                        <span className="soft">
                          {" "}
                          ({(other.longer > 0 ? w.longer : w.shorter)(timeWords(words, Math.abs(other.longer)))})
                        </span>
                      )}
                    </span>
                    <span className="small">
                      {Math.abs(other.leaves) < SAME_AREA
                        ? w.sameResult
                        : (other.leaves > 0 ? w.leaves : w.takesMore)(areaWords(words, Math.abs(other.leaves)))}
                    </span>
                    {!isSecond && (
                      <button
                        type="button"
                        className="button small"
                        disabled={!canChange}
                        aria-label={w.useLong(index + 1, name)}
                        onClick={() => takeWay(index, way.key)}
                      >
                        {w.use}
                      </button>
                    )}
                  </li>
                );
              })}
            </ul>
          )}
          {!isSecond && (
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
          )}
        </div>
      )}
    </li>
  );
}
