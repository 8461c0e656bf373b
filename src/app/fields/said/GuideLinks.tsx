import "./prompt-more.css";
import { useTexts } from "../../base/settings/use-texts.ts";

/** Links to the guide of all cycles and to the glossary. */
export function GuideLinks() {
  const t = useTexts("guide");
  return (
    <p className="guide-ways">
      <a href="#/guide">{t.cycles.title}</a> · <a href="#/glossary">{t.glossary.title}</a>
    </p>
  );
}
