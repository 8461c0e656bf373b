import { useState } from "react";
import { openText } from "../../../app/document/printed.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { forgetReports, reportText, useReports } from "../../../app/records/reports.ts";

/** The text of the open work; null if it cannot be printed. */
function printableText(): string | null {
  try {
    return openText();
  } catch {
    return null;
  }
}

const copy = (text: string): Promise<"copied" | "notCopied"> =>
  navigator.clipboard.writeText(text).then(
    () => "copied" as const,
    () => "notCopied" as const,
  );

/** The error reports of this device: view, copy, delete. */
export function ReportList({ open = false }: { readonly open?: boolean }) {
  const { reports: t } = useTexts("device");
  const language = useSettings((s) => s.language);
  const { list } = useReports();
  const [chosen, choose] = useState(0);
  const [withProgram, add] = useState(false);
  const [copied, setCopied] = useState<"no" | "copied" | "notCopied">("no");
  const report = list[chosen] ?? list[0];
  const when = new Intl.DateTimeFormat(language, { dateStyle: "medium", timeStyle: "medium" });
  const hasProgram = printableText() !== null;
  if (!report) return <p className="soft small">{t.none}</p>;
  const text = reportText(report, withProgram ? printableText() : null);
  return (
    <div className="reports">
      <p className="soft small">{t.lead}</p>
      {list.length > 1 && (
        <select
          className="select"
          aria-label={t.title}
          value={chosen}
          onChange={(event) => {
            choose(Number(event.target.value));
            setCopied("no");
          }}
        >
          {list.map(({ at, message }, i) => (
            <option key={i} value={i}>{`${when.format(at)} · ${message.slice(0, 40)}`}</option>
          ))}
        </select>
      )}
      <textarea className="number" readOnly rows={open ? 10 : 5} aria-label={t.text} value={text} />
      {hasProgram && (
        <label className="report-program">
          <input
            type="checkbox"
            checked={withProgram}
            onChange={() => {
              add(!withProgram);
              setCopied("no");
            }}
          />
          <span>{t.withProgram}</span>
        </label>
      )}
      <div className="bring-buttons">
        <button type="button" className="button" onClick={() => void copy(text).then(setCopied)}>
          {t.copy}
        </button>
        <button type="button" className="button" onClick={forgetReports}>
          {t.remove}
        </button>
        <span role="status">{copied !== "no" && t[copied]}</span>
      </div>
    </div>
  );
}
