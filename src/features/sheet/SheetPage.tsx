import { useEffect, useState } from "react";
import { time } from "../../app/base/clock.ts";
import { measuredIn, setRemarks } from "../../app/document/edits.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { changeSettings, PAPERS, useSettings } from "../../app/base/settings/settings.ts";
import { closeStep } from "../../app/document/steps.ts";
import { useEditor } from "../../app/document/store.ts";
import { LONGEST_REMARKS } from "../../app/document/work.ts";
import { SetupSheet } from "./SetupSheet.tsx";
import { uncover } from "../../app/place/place.ts";
import { useSheetSource } from "./use-sheet.ts";
import "./sheet.css";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** The time stamp of the sheet; printing renews it. */
function useNow(): Date {
  const [now, take] = useState(() => new Date(time()));
  useEffect(() => {
    const again = () => take(new Date(time()));
    addEventListener("beforeprint", again);
    return () => removeEventListener("beforeprint", again);
  }, []);
  return now;
}

/** The footer of each printed page; the printer numbers the pages. */
function usePrintFooter(text: string, page: string): void {
  useEffect(() => {
    const { style } = document.documentElement;
    style.setProperty("--sheet-foot", JSON.stringify(text));
    style.setProperty("--sheet-page", page);
    return () => {
      style.removeProperty("--sheet-foot");
      style.removeProperty("--sheet-page");
    };
  }, [text, page]);
}

/** The sheet for the setter, as it will be printed, with the chosen options and remarks. */
export function SheetPage() {
  const t = useTexts("sheet");
  const source = useSheetSource();
  const { language, paper, sheetProgram, sheetMeasured } = useSettings();
  const isMeasured = useEditor((s) => measuredIn(s).length > 0);
  const now = useNow();
  const date = new Intl.DateTimeFormat(language, { dateStyle: "medium", timeStyle: "short" }).format(now);
  const { before, of, after } = t.page;
  usePrintFooter(
    source ? [source.data.name || source.file, date, `Turnwise ${import.meta.env["VITE_VERSION"]}`].join(" · ") : "",
    `${JSON.stringify(before)} counter(page) ${JSON.stringify(of)} counter(pages) ${JSON.stringify(after)}`,
  );
  if (!source) return null;
  return (
    <main className="sheet-page">
      <section className="sheet-bar" aria-label={t.title}>
        <div className="sheet-buttons">
          <button type="button" className="button" onClick={uncover}>
            <Icon name="back" /> {t.close}
          </button>
          <label>
            <span>{t.paper}</span>
            <select
              className="select"
              value={paper}
              onChange={({ currentTarget: { value } }) => {
                const chosen = PAPERS.find((each) => each === value);
                if (chosen) changeSettings({ paper: chosen });
              }}
            >
              {PAPERS.map((each) => (
                <option key={each} value={each}>
                  {t.papers[each]}
                </option>
              ))}
            </select>
          </label>
          <label className="sheet-check">
            <input
              type="checkbox"
              checked={sheetProgram}
              onChange={(e) => changeSettings({ sheetProgram: e.currentTarget.checked })}
            />
            <span>{t.withProgram}</span>
          </label>
          {isMeasured && (
            <label className="sheet-check">
              <input
                type="checkbox"
                checked={sheetMeasured}
                onChange={(e) => changeSettings({ sheetMeasured: e.currentTarget.checked })}
              />
              <span>{t.withMeasured}</span>
            </label>
          )}
          <button type="button" className="button primary" title={t.printHint} onClick={() => print()}>
            <Icon name="print" /> {t.print}
          </button>
        </div>
        <label className="sheet-write">
          <span>{t.remarks}</span>
          <textarea
            rows={2}
            maxLength={LONGEST_REMARKS}
            placeholder={t.remarksHint}
            value={source.remarks}
            onChange={(e) => setRemarks(e.currentTarget.value)}
            onBlur={closeStep}
          />
        </label>
      </section>
      <SetupSheet source={source} t={t} date={date} />
    </main>
  );
}
