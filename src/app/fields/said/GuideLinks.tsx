import "./prompt-more.css";
import { useTexts } from "../../base/settings/use-texts.ts";

/** The ways to the guide of all cycles and to the words of the trade. */
export function GuideLinks() {
  const t = useTexts("guide");
  return (
    <p className="guide-ways">
      <a href="#/guide">{t.cycles.title}</a> · <a href="#/glossary">{t.glossary.title}</a>
    </p>
  );
}
