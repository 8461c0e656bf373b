import { useState } from "react";
import { parse } from "../../../nc/parse.ts";
import { statementLines } from "../../../nc/print.ts";
import { LAYOUTS } from "../../../nc/style.ts";
import { linesOfText } from "../../../course/made/task-from-form.ts";
import { rowsFrom } from "../../../program/job/contour-of-text.ts";
import type { ContourRow } from "../../../program/job/job.ts";
import { contourStatements } from "../../../program/job/print-contour.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { lazyPart } from "../../../app/base/parts.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { contourSlot } from "../../../app/fields/slots.ts";
import { TeachText } from "./WordFields.tsx";

const ContourTable = lazyPart(async () => ({ default: (await contourSlot.fetch()).ContourTable }));

const textOf = (rows: readonly ContourRow[]): string =>
  contourStatements(rows)
    .flatMap((statement) => statementLines(statement, LAYOUTS.tnc7))
    .join("\n");

/** The rows of an outline; null where a line is no element of the table, which would be lost in it. */
function rowsOfText(text: string): readonly ContourRow[] | null {
  const lines = linesOfText(text);
  const rows = rowsFrom(parse(lines.join("\n")), 0);
  return rows.length === lines.length ? rows : null;
}

/** An outline as lines of a contour, or in the table of the contour editor with its drawing. */
export function OutlineField({
  label,
  text,
  change,
}: {
  readonly label: string;
  readonly text: string;
  readonly change: (text: string) => void;
}) {
  const t = useTexts("course-teach"),
    words = useTexts("course-set");
  const language = useSettings((s) => s.language);
  /** The rows of the table and the text that they make: a row that is not complete has no line yet. */
  const [table, edit] = useState<{ readonly rows: readonly ContourRow[]; readonly text: string } | null>(null);
  const rows = table && (table.text === text ? table.rows : rowsOfText(text));
  const own = rows ?? rowsOfText(text);
  return (
    <div className="teach-outline" role="group" aria-label={label}>
      {rows ? (
        <>
          <b>{label}</b>
          <ContourTable
            rows={rows}
            language={language}
            onChange={(next) => {
              const made = textOf(next);
              edit({ rows: next, text: made });
              change(made);
            }}
          />
        </>
      ) : (
        <TeachText
          label={label}
          hint={t.partHint}
          isNc
          rows={Math.min(12, Math.max(2, text.split("\n").length))}
          value={text}
          change={change}
        />
      )}
      {own && (
        <button type="button" className="button" onClick={() => edit(rows ? null : { rows: own, text })}>
          <Icon name={rows ? "unfold" : "rename"} /> {rows ? words.asText : words.asContour}
        </button>
      )}
    </div>
  );
}
