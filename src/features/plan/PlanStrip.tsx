import type { WorkingPlan } from "../../planning/working-plan.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { Unbroken } from "../../app/base/Unbroken.tsx";
import { openText } from "../../app/fields/open/open-program.ts";
import { setMaterial } from "../../app/document/edits.ts";
import { toFirstPrompt } from "../../app/place/place.ts";
import type { StoredPart } from "../../app/records/part-store.ts";
import { usePlanPlace } from "./plan-place.ts";
import { startPlan, stopSearch, usePlans, type MadePlan } from "./plan-store.ts";
import { planOfClamping } from "./PlanTab.tsx";
import { addCalledTools } from "./usual-tools.ts";
import { changeSeconds, timeWords, verdictWords, type PlanWords } from "../../app/fields/plan/plan-words.ts";

interface Props {
  readonly words: PlanWords;
  readonly stored: StoredPart;
  readonly made: MadePlan | null;
  readonly isOutdated: boolean;
  readonly onPlan: () => void;
}

/** Opens the program of a plan as a new work, with the material of its part. */
function openPlan(plan: WorkingPlan, { part }: StoredPart): void {
  toFirstPrompt();
  openText(plan.text);
  addCalledTools(plan.tools);
  if (part.material !== "") setMaterial(part.material);
}

const toneOf = ({ isGood, isProved }: ReturnType<typeof verdictWords>): string =>
  isGood ? "plan-good" : isProved ? "plan-warned" : "plan-bad";

/** What the plan achieves, the search in progress, and the ways to plan and to open the program. */
export function PlanStrip({ words, stored, made, isOutdated, onPlan }: Props) {
  const { t } = words;
  const running = usePlans((s) => s.running),
    ended = usePlans((s) => s.ended);
  const clamping = usePlanPlace((p) => p.clamping);
  const plan = planOfClamping(made, clamping);
  const isRunning = running !== null,
    isSecond = plan !== null && plan === made?.plan?.second;
  const verdict = plan && verdictWords(words, plan),
    changes = plan ? changeSeconds(plan) : 0;
  const begin = () => {
    onPlan();
    startPlan();
  };
  const progress = running?.progress;
  const idle = (): string => {
    if (stored.part.outside.length === 0) return t.run.empty;
    if (ended === "failed") return t.run.failed;
    return ended === "stopped" ? t.run.stopped : t.run.ready;
  };
  return (
    <section className="plan-strip" aria-label={t.result.title}>
      <div className="plan-said" role="status" aria-busy={isRunning}>
        {isRunning && (
          <>
            <b>{t.run.searching(progress?.tries ?? 0)}</b>
            {progress && progress.done.length > 0 && (
              <span className="small soft">
                <Unbroken
                  text={(progress.isWhole ? t.run.best : t.run.begun)(
                    t.run.operations(progress.done.length),
                    timeWords(words, progress.seconds),
                  )}
                />
              </span>
            )}
          </>
        )}
        {!isRunning && !made && <span className="soft">{idle()}</span>}
        {!isRunning && made && !made.plan && (
          <b className="plan-bad">
            <Icon name="error" /> {t.run.problems}
          </b>
        )}
        {!isRunning && plan && verdict && (
          <>
            <b className={isOutdated ? "soft" : toneOf(verdict)}>
              <Icon name={isOutdated ? "info" : verdict.isGood ? "check" : "warning"} />{" "}
              {isOutdated ? t.run.outdated : verdict.text}
            </b>
            <span className="small soft">
              <Unbroken
                text={t.run.done(
                  t.run.operations(plan.steps.length),
                  timeWords(words, plan.seconds - changes),
                  timeWords(words, changes),
                )}
              />
            </span>
            {ended === "failed" && <span className="small plan-bad">{t.run.failed}</span>}
            {ended === "stopped" && <span className="small">{t.run.stoppedAgain}</span>}
          </>
        )}
      </div>
      {plan && !isRunning && (
        <dl className="plan-facts">
          <div>
            <dt>{t.result.tools}</dt>
            <dd className="number">{plan.tools.map((T) => `T${T}`).join(" ")}</dd>
          </div>
          <div>
            <dt>{t.result.changes}</dt>
            <dd className="number">{plan.toolChanges}</dd>
          </div>
        </dl>
      )}
      {isRunning && (
        <progress aria-label={t.title} {...(progress && { value: progress.tries, max: Math.max(progress.most, 1) })} />
      )}
      <div className="plan-ways">
        {isRunning ? (
          <button type="button" className="button" onClick={stopSearch}>
            <Icon name="close" /> {t.run.stop}
          </button>
        ) : (
          <button
            type="button"
            className={`button${!plan || isOutdated ? " primary" : ""}`}
            disabled={stored.part.outside.length === 0}
            onClick={begin}
          >
            {made ? t.run.again : t.run.plan}
          </button>
        )}
        {plan && plan.steps.length > 0 && (
          <button
            type="button"
            className={`button${isOutdated || isRunning ? "" : " primary"}`}
            disabled={isOutdated || isRunning}
            onClick={() => openPlan(plan, stored)}
          >
            {isSecond ? t.result.openSecond : t.result.open}
          </button>
        )}
      </div>
    </section>
  );
}
