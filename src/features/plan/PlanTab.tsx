import { useEffect, useRef } from "react";
import type { Residue, WorkingPlan } from "../../planning/working-plan.ts";
import { Message } from "../../app/base/Message.tsx";
import { Unbroken } from "../../app/base/Unbroken.tsx";
import type { Clamping, StoredPart } from "../../app/records/part-store.ts";
import { forgetHand, previewValues, startPlan, type MadePlan } from "./plan-store.ts";
import { pointAtRows, showClamping, usePlanPlace } from "./plan-place.ts";
import { areaWords, missingWords, regionPlace, type PlanWords } from "../../app/fields/plan/plan-words.ts";
import { ProblemList } from "./ProblemList.tsx";
import { StepItem } from "./StepItem.tsx";

interface Props {
  readonly words: PlanWords;
  readonly stored: StoredPart;
  readonly made: MadePlan | null;
  readonly isOutdated: boolean;
  readonly isRunning: boolean;
}

/** The plan of the second clamping, where it has an operation. */
const secondOf = (made: MadePlan | null): WorkingPlan | null => {
  const second = made?.plan?.second ?? null;
  return second && second.steps.length > 0 ? second : null;
};

/** The plan of the clamping that is shown. */
export const planOfClamping = (made: MadePlan | null, clamping: Clamping): WorkingPlan | null => {
  const plan = made?.plan ?? null;
  return clamping === "second" ? (secondOf(made) ?? plan) : plan;
};

/** What a plan does not make, and the tool that would. */
function LeftList({ words, residue }: { readonly words: PlanWords; readonly residue: readonly Residue[] }) {
  const { left } = words.t;
  if (residue.length === 0) return null;
  return (
    <section className="plan-left" aria-label={left.title}>
      <h2>{left.title}</h2>
      <p className="small soft plan-left-about">
        <Unbroken text={left.about} />
      </p>
      <ul>
        {residue.map((each, i) => (
          <li key={i} onPointerEnter={() => pointAtRows(each.rows)} onPointerLeave={() => pointAtRows(null)}>
            <b>
              {each.region
                ? left.region(areaWords(words, each.region.area), left.where[each.site])
                : left.thread(each.thread)}
            </b>
            {each.region && <span className="small soft number">{regionPlace(words, each.region.box)}</span>}
            <span>{left.why[each.why]}</span>
            {each.missing && (
              <span className="small">
                <Unbroken text={left.missing(missingWords(words, each.missing))} />
              </span>
            )}
          </li>
        ))}
      </ul>
    </section>
  );
}

/** The operations of the plan, why they are so, and what is not made. */
export function PlanTab({ words, stored, made, isOutdated, isRunning }: Props) {
  const { t } = words;
  const { open, clamping } = usePlanPlace();
  const list = useRef<HTMLOListElement>(null);
  const plan = planOfClamping(made, clamping),
    second = secondOf(made);
  const shownClamping: Clamping = second !== null && plan === second ? "second" : "first",
    hand = stored[shownClamping]?.hand ?? {},
    orphans = Object.keys(hand).filter((key) => !plan?.steps.some(({ tried }) => tried.action.key === key));
  const at = useRef<number | null>(null);
  // A new plan keeps the focus at the operation that was changed: its button may be gone.
  useEffect(() => {
    const { current } = at;
    if (current === null || isRunning || document.activeElement !== document.body) return;
    const names = list.current?.querySelectorAll<HTMLElement>(".plan-step-name");
    names?.[Math.min(current, names.length - 1)]?.focus({ preventScroll: true });
  }, [made, isRunning]);
  if (!made) return <p className="plan-none soft">{t.run.about}</p>;
  return (
    <div className={`plan-result${isOutdated ? " outdated" : ""}`}>
      {isOutdated && (
        <div className="plan-outdated" role="status">
          <Message tone="warning">{t.run.outdated}</Message>
          <button type="button" className="button" disabled={isRunning} onClick={startPlan}>
            {t.run.again}
          </button>
        </div>
      )}
      <ProblemList words={words} part={stored.part} problems={made.problems} />
      {second && (
        <div className="view-switch plan-sides" role="group" aria-label={t.result.title}>
          {(["first", "second"] as const).map((each) => (
            <button
              key={each}
              type="button"
              className="button"
              aria-pressed={clamping === each}
              onClick={() => showClamping(each)}
            >
              {t.result[each]}
            </button>
          ))}
        </div>
      )}
      {plan && (
        <>
          {plan === second && !plan.setup.clamping && stored.part.clamping && (
            <div className="plan-note">
              <Message tone="warning">{t.result.unheld}</Message>
            </div>
          )}
          {plan.steps.length === 0 && <p className="plan-none">{t.run.none}</p>}
          <ol
            className="plan-steps"
            aria-label={t.steps.title}
            ref={list}
            onFocus={({ target }) => {
              const item = target.closest("li.plan-step");
              at.current = item ? [...(list.current?.children ?? [])].indexOf(item) : null;
            }}
          >
            {plan.steps.map((step, i) => (
              <StepItem
                key={i}
                words={words}
                stored={stored}
                step={step}
                index={i}
                isOpen={open === i}
                isLocked={Object.hasOwn(hand, step.tried.action.key)}
                clamping={shownClamping}
                canChange={!isRunning && !isOutdated}
                preview={(values) => previewValues(made, plan, i, values)}
              />
            ))}
          </ol>
          {orphans.length > 0 && !isRunning && (
            <div className="plan-note">
              <Message tone="warning">{t.steps.orphans(orphans.length)}</Message>
              <button type="button" className="button small" onClick={() => forgetHand(shownClamping, orphans)}>
                {t.steps.forget}
              </button>
            </div>
          )}
          <LeftList words={words} residue={plan.residue} />
        </>
      )}
    </div>
  );
}
