import { useContext } from "react";
import { cycleByNumber } from "../../cycles/index.ts";
import { CycleInWork } from "../issue-text.ts";
import { Icon } from "../Icon.tsx";
import { showGuide } from "./guide-place.ts";
import { useGuideTextsSoon } from "./use-guide-texts.ts";
import "./prompt-more.css";

/** The way from an open prompt to the page of its parameter. */
export function PromptMore({ id }: { readonly id: string }) {
  const cycle = useContext(CycleInWork);
  const t = useGuideTextsSoon();
  if (!t || cycle === null || !cycleByNumber(cycle)?.params[id]) return null;
  return (
    <button type="button" className="prompt-more" aria-label={t.moreAbout(id)} title={t.moreAbout(id)}
      onClick={() => showGuide("guide", String(cycle), id)}
    >
      <Icon name="question" /> {t.more}
    </button>
  );
}
