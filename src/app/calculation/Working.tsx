import { useTexts } from "../base/settings/use-texts.ts";
import { calculateAgain, cancelCalculation } from "./client.ts";
import { STAGES, useOutcome } from "./outcome.ts";
import { useLong } from "./use-long.ts";
import "./working.css";

/** What is done sooner than this is not worth a word, ms. */
const SOON = 700;
/** Over a path that is there already, whose proof says itself that it is at work, ms. */
const LATE = 4000;

/** Over the picture: what a long calculation is at, and a way to stop it. */
export function Working() {
  const { lathe: t } = useTexts();
  const stage = useOutcome((s) => s.stage);
  const planned = useOutcome((s) => s.planned !== null);
  const stopped = useOutcome((s) => s.stopped);
  const long = useLong(stage !== null, planned ? LATE : SOON);
  if (stage !== null && long)
    return (
      <div className="working panel" role="status">
        <p>{t.stages[stage]}</p>
        <progress aria-label={t.stages[stage]} value={STAGES.indexOf(stage) + 0.5} max={STAGES.length} />
        <button type="button" className="button" onClick={cancelCalculation}>
          {t.stopWorking}
        </button>
      </div>
    );
  if (!stopped) return null;
  return (
    <div className="working panel" role="status">
      <p>{t.stopped}</p>
      <button type="button" className="button" onClick={calculateAgain}>
        {t.workAgain}
      </button>
    </div>
  );
}
