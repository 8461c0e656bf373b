import { useTexts } from "../base/settings/use-texts.ts";
import { ANNOUNCE_AFTER } from "../base/waits.ts";
import { calculation } from "./calculation.ts";
import { STAGES, useOutcome } from "./outcome.ts";
import { useLongerThan } from "./use-longer-than.ts";
import "./working.css";

/** Stage of a long calculation, over the picture, with a button that stops it. */
export function Working() {
  const { lathe: t } = useTexts();
  const stage = useOutcome((s) => s.stage);
  const share = useOutcome((s) => s.share);
  const planned = useOutcome((s) => s.planned !== null);
  const stopped = useOutcome((s) => s.stopped);
  const long = useLongerThan(stage !== null, planned ? ANNOUNCE_AFTER.workingOverPath : ANNOUNCE_AFTER.working);
  if (stage !== null && long)
    return (
      <div className="working panel" role="status">
        <p>{t.stages[stage]}</p>
        <progress
          aria-label={t.stages[stage]}
          value={STAGES.indexOf(stage) + (stage === "proving" ? share : 0.5)}
          max={STAGES.length}
        />
        <button type="button" className="button" onClick={calculation.cancel}>
          {t.stopWorking}
        </button>
      </div>
    );
  if (!stopped) return null;
  return (
    <div className="working panel" role="status">
      <p>{t.stopped}</p>
      <button type="button" className="button" onClick={calculation.again}>
        {t.workAgain}
      </button>
    </div>
  );
}
