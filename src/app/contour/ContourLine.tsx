import { useId, type ReactNode } from "react";
import { texts } from "../settings/loaded-texts.ts";
import type { Language } from "../../i18n/languages.ts";
import { formatNumber } from "../../i18n/number.ts";
import type { RowField, RowIssue, RowReading } from "../../program/contour-rows.ts";
import type { ContourRow } from "../../program/job.ts";
import { Icon } from "../Icon.tsx";
import { issueText } from "../issue-text.ts";
import { ContourCell } from "./ContourCell.tsx";

interface Props {
  readonly row: ContourRow;
  /** Counted from 1. */
  readonly number: number;
  readonly reading: RowReading | undefined;
  readonly issues: readonly RowIssue[];
  readonly active: boolean;
  readonly language: Language;
  readonly onChange: (change: Partial<ContourRow>, place: string | null) => void;
  readonly onFocus: () => void;
}

const KINDS = ["L", "CR", "RND", "CHF"] as const;

/** One element of the contour: its fields, and below them what is wrong with it. */
export function ContourLine({ row, number, reading, issues, active, language, onChange, onFocus }: Props) {
  const all = texts(language), t = all.contour;
  const id = useId();
  const path = row.kind === "L" || row.kind === "CR";
  const stays = (value: number | null | undefined) => (value === null || value === undefined ? null : formatNumber(language, value));
  const cell = (field: RowField, name: string, inherited: string | null, incremental?: { on: boolean; name: string; toggle: () => void }): ReactNode => (
    <ContourCell
      row={row.id} field={field} name={name} language={language} text={row[field]} inherited={inherited} describedBy={`${id}-wrong`}
      wrong={issues.some((found) => found.field === field)}
      onText={(text) => text !== row[field] && onChange({ [field]: text }, `${row.id} ${field}`)}
      {...(incremental ? { incremental } : {})}
    />
  );
  const size = row.kind === "CHF" ? t.chamferOf(number) : t.radiusOf(number);
  return (
    <tr role="row" className={`contour-line kind-${row.kind}${active ? " active" : ""}`} onFocus={onFocus} {...(active ? { "aria-current": true } : {})}>
      <th role="rowheader" scope="row" className="contour-number number">{number}</th>
      <td role="cell" className="contour-kind">
        <select
          className="select" aria-label={t.kindOf(number)} value={row.kind} data-row={row.id} data-field="kind"
          onChange={(e) => onChange({ kind: e.currentTarget.value as ContourRow["kind"] }, null)}
        >
          {KINDS.map((kind) => <option key={kind} value={kind}>{`${kind} ${t.kinds[kind]}`}</option>)}
        </select>
      </td>
      <td role="cell" className="contour-x">
        {path && cell("x", t.xOf(number), row.x.trim() === "" ? stays(reading?.inherited.x) : null,
          { on: row.incrementalX, name: t.incrementalX(number), toggle: () => onChange({ incrementalX: !row.incrementalX }, null) })}
      </td>
      <td role="cell" className="contour-z">
        {path && cell("z", t.zOf(number), row.z.trim() === "" ? stays(reading?.inherited.z) : null,
          { on: row.incrementalZ, name: t.incrementalZ(number), toggle: () => onChange({ incrementalZ: !row.incrementalZ }, null) })}
      </td>
      <td role="cell" className="contour-size">{row.kind !== "L" && cell("r", size, null)}</td>
      <td role="cell" className="contour-turn">
        {row.kind === "CR" && (
          <select
            className="select" aria-label={t.turnOf(number)} value={row.turn} data-row={row.id} data-field="turn"
            onChange={(e) => onChange({ turn: e.currentTarget.value as ContourRow["turn"] }, null)}
          >
            <option value="cw">{t.clockwise}</option>
            <option value="ccw">{t.counterClockwise}</option>
          </select>
        )}
      </td>
      <td role="cell" className="contour-wrong" id={`${id}-wrong`}>
        {issues.map((found, i) => (
          <p key={i} className="field-message error small"><Icon name="error" /> {issueText(all, language, found.issue, null)}</p>
        ))}
      </td>
    </tr>
  );
}
