import { useEffect, useState } from "react";
import { blockNumbers } from "../../nc/program.ts";
import { parse } from "../../nc/parse.ts";
import { loadSheet } from "../../i18n/load-sheet.ts";
import type { SheetTexts } from "../../i18n/en/sheet.ts";
import { setRemarks } from "../edits.ts";
import { VerdictText } from "../findings/VerdictText.tsx";
import { useVerdict } from "../findings/use-findings.ts";
import { Icon } from "../Icon.tsx";
import { printedText, programName } from "../printed.ts";
import { useSettings } from "../settings/settings.ts";
import { closeStep } from "../steps.ts";
import { useEditor } from "../store.ts";
import { LONGEST_REMARKS } from "../work.ts";
import { hideSheet } from "./sheet-place.ts";
import "./sheet.css";

/** The texts of the sheet in the screen language; null until they are here. */
function useSheetTexts(): SheetTexts | null {
  const language = useSettings((s) => s.language);
  const [texts, take] = useState<SheetTexts | null>(null);
  useEffect(() => {
    let gone = false;
    void loadSheet(language).then((loaded) => {
      if (!gone) take(loaded);
    });
    return () => {
      gone = true;
    };
  }, [language]);
  return texts;
}

/** The sheet for the setter, as it will be printed, with what is chosen and written on it. */
export function SheetPage() {
  const t = useSheetTexts();
  const work = useEditor((s) => s.job ?? s.program);
  const text = useEditor((s) => (s.job ? printedText(s.job) : s.program?.text ?? ""));
  const verdict = useVerdict();
  if (!t || !work) return null;
  const program = parse(text);
  const numbers = blockNumbers(program);
  return (
    <main className="sheet-page">
      <div className="sheet-tools">
        <button type="button" className="button" onClick={hideSheet}>
          <Icon name="back" /> {t.close}
        </button>
        <button type="button" className="button primary" onClick={() => print()}>
          <Icon name="print" /> {t.print}
        </button>
        <label>
          <span>{t.remarks}</span>
          <textarea rows={3} maxLength={LONGEST_REMARKS} value={work.remarks ?? ""} onChange={(e) => setRemarks(e.currentTarget.value)}
            onBlur={closeStep} />
        </label>
      </div>
      <article className="setup-sheet" aria-label={t.title}>
        <h2>{programName(text)}</h2>
        <VerdictText verdict={verdict} reasons={4} />
        {work.remarks && <p className="sheet-remarks">{work.remarks}</p>}
        <h3>{t.program}</h3>
        <ol className="sheet-program number">
          {program.blocks.map((block, i) => <li key={i}>{block.number === null ? `${numbers[i]} ${block.raw}` : block.raw}</li>)}
        </ol>
      </article>
    </main>
  );
}
