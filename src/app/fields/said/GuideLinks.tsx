import { useGuideTexts } from "./use-guide-texts.ts";
import "./prompt-more.css";

/** The ways to the guide of all cycles and to the words of the trade. */
export function GuideLinks() {
  const t = useGuideTexts();
  return (
    <p className="guide-ways">
      <a href="#/guide">{t.cycles.title}</a> · <a href="#/glossary">{t.glossary.title}</a>
    </p>
  );
}
