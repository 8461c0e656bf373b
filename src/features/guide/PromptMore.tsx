import { cycleByNumber } from "../../cycles/index.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { useSettings } from "../../app/base/settings/settings.ts";
import { type GuidePath, showGuide } from "../../app/place/place.ts";
import { useAdviceOn } from "../../app/fields/said/use-advice.ts";
import "../../app/fields/said/prompt-more.css";
import { useTextsOrNull } from "../../app/base/settings/use-texts.ts";

/** A quiet mark if there is advice on the value of a prompt. */
function AdviceMark({ cycle, q }: { readonly cycle: number; readonly q: string }) {
  const t = useTextsOrNull("advice");
  const { length: count } = useAdviceOn(cycle, q);
  if (!t || count === 0) return null;
  return (
    <button type="button" className="prompt-more prompt-advice" onClick={() => showGuide("guide", String(cycle), q)}>
      <Icon name="info" /> {t.mark(count)}
    </button>
  );
}

/** The link from a prompt to its guide page, and to the advice on its value. */
export function PromptMore({ page, name }: { readonly page: GuidePath; readonly name: string }) {
  const t = useTextsOrNull("guide");
  const on = useSettings((s) => s.advice);
  if (!t) return null;
  const [, first, q] = page;
  const cycle = Number(first);
  return (
    <>
      {on && q !== undefined && cycleByNumber(cycle)?.params[q] && <AdviceMark cycle={cycle} q={q} />}
      <button
        type="button"
        className="prompt-more"
        aria-label={t.moreAbout(name)}
        title={t.moreAbout(name)}
        onClick={() => showGuide(...page)}
      >
        <Icon name="question" /> {t.more}
      </button>
    </>
  );
}
