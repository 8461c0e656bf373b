import { memo, useState, type ReactNode } from "react";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { Language } from "../../i18n/languages.ts";
import type { ContourRow } from "../../program/job/job.ts";
import { texts } from "../../app/base/settings/loaded-texts.ts";
import { ContourDrawing } from "./ContourDrawing.tsx";
import { useReading } from "./begun-field.ts";
import { chooseElement, goToElement, useChosenRow } from "../../app/place/contour-place.ts";
import { FaultList } from "./FaultList.tsx";
import { OpenDrawing } from "./OpenDrawing.tsx";
import { withRow, type Edited } from "./row-edits.ts";
import "./contour.css";

interface Props {
  readonly rows: readonly ContourRow[];
  readonly blank: readonly Ring[];
  readonly language: Language;
  /** `place` names the gesture, so that it is one step of undo; null for a separate step. */
  readonly onChange: (rows: readonly ContourRow[], place: string | null) => void;
  /** Controls in front of the tools. */
  readonly lead: ReactNode;
}

/** The contour on the large canvas, with its dimensions, next to its table. */
export const ContourStage = memo(Stage);

function Stage({ rows, blank, language, onChange, lead }: Props) {
  const t = texts(language).contour;
  const reading = useReading(rows),
    active = useChosenRow(rows);
  const [said, setSaid] = useState({ text: "", times: 0 });
  const edited = (next: Edited) => {
    if (next.rows === rows) return;
    chooseElement(next.focus);
    setSaid((old) => ({ text: t.done.added, times: old.times + 1 }));
    onChange(next.rows, null);
  };
  const idOf = (row: number) => rows[row]?.id ?? null;
  const type = () => {
    const next = withRow(rows, rows.length);
    onChange(next.rows, null);
    goToElement(next.focus);
  };
  const empty = (
    <div className="contour-empty">
      <p>{t.emptyDrawing}</p>
      <div className="contour-empty-buttons">
        <button type="button" className="button primary" onClick={type}>
          {t.typeFirst}
        </button>
        <OpenDrawing />
      </div>
    </div>
  );
  return (
    <section className="contour-stage" aria-label={t.canvas}>
      <ContourDrawing
        rows={rows}
        reading={reading}
        active={active}
        language={language}
        canvas={{ blank, lead, empty }}
        onPick={(row) => chooseElement(idOf(row))}
        onRows={onChange}
        onEdited={edited}
      />
      <FaultList issues={reading.issues} language={language} onPick={(row) => goToElement(idOf(row))} />
      <p role="status" className="unseen">
        <span key={said.times}>{said.text}</span>
      </p>
    </section>
  );
}
