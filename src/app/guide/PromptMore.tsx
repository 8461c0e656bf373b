import { useContext } from "react";
import { cycleByNumber } from "../../cycles/index.ts";
import { CycleInWork } from "../issue-text.ts";
import { Icon } from "../Icon.tsx";
import { useSettings } from "../settings/settings.ts";
import { showGuide } from "./guide-place.ts";
import { useAdviceOn, useAdviceTextsSoon } from "./use-advice.ts";
import { useGuideTextsSoon } from "./use-guide-texts.ts";
import "./prompt-more.css";

/** A quiet mark where there is advice on the value of a prompt. */
function AdviceMark({ cycle, q }: { readonly cycle: number; readonly q: string }) {
  const t = useAdviceTextsSoon();
  const { length: count } = useAdviceOn(cycle, q);
  if (!t || count === 0) return null;
  return (
    <button type="button" className="prompt-more prompt-advice" onClick={() => showGuide("guide", String(cycle), q)}>
      <Icon name="info" /> {t.mark(count)}
    </button>
  );
}

/** The way from an open prompt to the page of its parameter, and to what there is to say about its value. */
export function PromptMore({ id }: { readonly id: string }) {
  const cycle = useContext(CycleInWork);
  const t = useGuideTextsSoon();
  const on = useSettings((s) => s.advice);
  if (!t || cycle === null || !cycleByNumber(cycle)?.params[id]) return null;
  return (
    <span className="prompt-ways">
      {on && <AdviceMark cycle={cycle} q={id} />}
      <button type="button" className="prompt-more" aria-label={t.moreAbout(id)} title={t.moreAbout(id)}
        onClick={() => showGuide("guide", String(cycle), id)}
      >
        <Icon name="question" /> {t.more}
      </button>
    </span>
  );
}
