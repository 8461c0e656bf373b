import { memo, useId, useRef, type ReactNode } from "react";
import { texts } from "../../app/base/settings/loaded-texts.ts";
import type { Language } from "../../i18n/languages.ts";
import { formatNumber } from "../../i18n/number.ts";
import type { RowField, RowIssue, RowReading } from "../../program/job/contour-rows.ts";
import type { ContourRow } from "../../program/job/job.ts";
import { axial, diameter, toRadius } from "../../kernel/units.ts";
import { polarNames, polarOf, polarTyped, withPolar, type PolarName } from "../../program/job/polar-row.ts";
import type { UndercutPlace } from "../../program/job/undercut-name.ts";
import { Message } from "../../app/base/Message.tsx";
import { issueText } from "../../app/calculation/issue-text.ts";
import { closeStep } from "../../app/document/steps.ts";
import { TypedTolerance } from "../../app/fields/number/TypedTolerance.tsx";
import { chooseElement } from "../../app/place/contour-place.ts";
import { RowNotes } from "./RowNotes.tsx";
import { RecessFields } from "./RecessFields.tsx";
import { Unbroken } from "../../app/base/Unbroken.tsx";
import { ContourCell, type Shown } from "./ContourCell.tsx";

interface Props {
  readonly row: ContourRow;
  /** Counted from 1. */
  readonly number: number;
  readonly reading: RowReading | undefined;
  /** Corner of an undercut; null for any other row. */
  readonly undercut: UndercutPlace | null;
  /** An undercut that was put in just now. */
  readonly isNew: boolean;
  readonly issues: readonly RowIssue[];
  readonly active: boolean;
  /** Whether the fields of angle, length and tangency are shown. */
  readonly details: boolean;
  readonly language: Language;
  /** In a long table, a digit is reported after it is painted. */
  readonly isLong: boolean;
  readonly onChange: (row: string, change: Partial<ContourRow>, place: string | null) => void;
}

const KINDS = ["L", "RND", "CHF", "CR", "CC", "C", "CT", "LP", "CP", "CTP", "UDC", "GRV"] as const;
/** Default form of a new undercut or recess. */
const firstForm = (kind: ContourRow["kind"]): Partial<ContourRow> =>
  kind === "UDC" ? { form: "E" } : kind === "GRV" ? { form: "RADIAL" } : {};
/** Elements with an end point or centre, with a size, with a turning direction, and those that can be tangential. */
const POINT = ["L", "CR", "CC", "C", "CT"],
  SIZE = ["RND", "CHF", "CR"],
  TURN = ["CR", "C", "CP"],
  TANGENTIAL = ["L", "CR", "C"];

/** Equal by value: each key anywhere in the table creates new reading objects. */
const isAlike = (a: unknown, b: unknown): boolean => a === b || JSON.stringify(a) === JSON.stringify(b);

/** One element of the contour: its fields, and its faults below them. Rendered only when one of its values changes. */
export const ContourLine = memo(
  Line,
  (a, b) =>
    a.row === b.row &&
    a.number === b.number &&
    a.active === b.active &&
    a.details === b.details &&
    a.language === b.language &&
    a.isLong === b.isLong &&
    a.onChange === b.onChange &&
    isAlike(a.reading, b.reading) &&
    isAlike(a.undercut, b.undercut) &&
    a.isNew === b.isNew &&
    isAlike(a.issues, b.issues),
);

function Line({
  row,
  number,
  reading,
  undercut,
  isNew,
  issues,
  active,
  details,
  language,
  isLong,
  onChange: changeRow,
}: Props) {
  const onChange = (change: Partial<ContourRow>, place: string | null) => changeRow(row.id, change, place);
  const all = texts(language),
    t = all.contour;
  const id = useId();
  const line = useRef<HTMLTableRowElement>(null);
  const write = (value: number) => formatNumber(language, value, 3);
  /** Placeholder of an empty field: the modal coordinate, the solved value, or open. */
  const shown = (
    typed: string,
    solved: boolean,
    value: number | null | undefined,
    stays: number | null | undefined,
  ): Shown | null => {
    if (typed.trim() !== "" && typed.trim() !== "?") return null;
    if (solved)
      return value === null || value === undefined
        ? { text: "?", name: t.undetermined, solved: true }
        : { text: write(value), name: t.solved(write(value)), solved: true };
    return stays === null || stays === undefined ? null : { text: write(stays), name: write(stays), solved: false };
  };
  const cell = (
    field: Exclude<RowField, PolarName>,
    name: string,
    grey: Shown | null,
    incremental?: { on: boolean; name: string; toggle: () => void },
  ): ReactNode => (
    <ContourCell
      row={row.id}
      field={field}
      name={name}
      text={row[field]}
      shown={grey}
      describedBy={`${id}-wrong`}
      isLong={isLong}
      wrong={issues.some((found) => found.field === field && found.issue.severity !== "info")}
      onText={(text) => onChange({ [field]: text }, `${row.id} ${field}`)}
      {...(incremental ? { incremental } : {})}
      {...(TANGENTIAL.includes(row.kind) && number > 1
        ? { onTangent: () => onChange({ tangent: !row.tangent }, null) }
        : {})}
    />
  );
  /** Puts a value into a field, which then has the focus: the button goes with its message. */
  const takeInto = (field: "x" | "z" | "r") => (value: number) => {
    line.current?.querySelector<HTMLElement>(`[data-field="${field}"]`)?.focus();
    closeStep();
    onChange({ [field]: String(value) }, null);
  };
  const polar = (name: PolarName): ReactNode => {
    if (!polarNames(row).includes(name)) return null;
    const typed = polarTyped(row, name),
      { x, z } = reading?.inherited ?? { x: null, z: null };
    const stays =
      reading?.pole && x !== null && z !== null
        ? polarOf(reading.pole, { z: axial(z), r: toRadius(diameter(x)) })[name]
        : null;
    const change = (next: Partial<typeof typed>, place: string | null) =>
      onChange({ words: withPolar(row.words, name, { ...typed, ...next }) }, place);
    return (
      <ContourCell
        row={row.id}
        field={name}
        name={(name === "PR" ? t.polarRadiusOf : t.polarAngleOf)(number)}
        text={typed.text}
        shown={shown(typed.text, false, null, stays)}
        describedBy={`${id}-wrong`}
        isLong={isLong}
        wrong={issues.some((found) => found.field === name && found.issue.severity !== "info")}
        onText={(text) => change({ text }, `${row.id} ${name}`)}
        incremental={{
          on: typed.incremental,
          name: (name === "PR" ? t.incrementalRadius : t.incrementalAngle)(number),
          toggle: () => change({ incremental: !typed.incremental }, null),
        }}
      />
    );
  };
  const size = row.kind === "CHF" ? t.chamferOf(number) : t.radiusOf(number);
  const measured = details && number > 1 && row.kind === "L",
    tangential = details && number > 1 && TANGENTIAL.includes(row.kind);
  const open = reading?.missingValues ?? 0;
  return (
    <tr
      ref={line}
      role="row"
      aria-rowindex={number + 1}
      className={`contour-line kind-${row.kind}${active ? " active" : ""}`}
      onFocus={() => chooseElement(row.id)}
      {...(active ? { "aria-current": true } : {})}
    >
      <th role="rowheader" scope="row" className="contour-number number">
        {number}
      </th>
      <td role="cell" className="contour-kind">
        <b className="number contour-code" aria-hidden="true">
          {row.kind}
        </b>
        <select
          className="select"
          aria-label={t.kindOf(number)}
          title={t.kinds[row.kind]}
          value={row.kind}
          data-row={row.id}
          data-field="kind"
          onChange={(e) => {
            const kind = e.currentTarget.value as ContourRow["kind"];
            onChange({ kind, ...firstForm(kind) }, null);
          }}
        >
          {KINDS.map((kind) => (
            <option key={kind} value={kind}>{`${kind} ${t.kinds[kind]}`}</option>
          ))}
        </select>
      </td>
      <td role="cell" className="contour-x">
        {polar("PR")}
        {POINT.includes(row.kind) &&
          cell(
            "x",
            t.xOf(number),
            shown(row.x, reading?.solvedAxes.x === true, reading?.end?.x, reading?.inherited.x),
            {
              on: row.incrementalX,
              name: t.incrementalX(number),
              toggle: () => onChange({ incrementalX: !row.incrementalX }, null),
            },
          )}
      </td>
      <td role="cell" className="contour-z">
        {polar("PA")}
        {POINT.includes(row.kind) &&
          cell(
            "z",
            t.zOf(number),
            shown(row.z, reading?.solvedAxes.z === true, reading?.end?.z, reading?.inherited.z),
            {
              on: row.incrementalZ,
              name: t.incrementalZ(number),
              toggle: () => onChange({ incrementalZ: !row.incrementalZ }, null),
            },
          )}
      </td>
      <td role="cell" className="contour-size">
        {SIZE.includes(row.kind) &&
          cell(
            "r",
            size,
            row.kind === "CR" ? shown(row.r, row.tangent || row.r.trim() === "?", reading?.radius, null) : null,
          )}
        {measured && cell("angle", t.angleOf(number), shown(row.angle, true, reading?.angle, null))}
      </td>
      <td role="cell" className="contour-turn">
        {TURN.includes(row.kind) && (
          <select
            className="select"
            aria-label={t.turnOf(number)}
            value={row.turn}
            data-row={row.id}
            data-field="turn"
            onChange={(e) => onChange({ turn: e.currentTarget.value as ContourRow["turn"] }, null)}
          >
            <option value="cw">{t.clockwise}</option>
            <option value="ccw">{t.counterClockwise}</option>
          </select>
        )}
        {measured && cell("length", t.lengthOf(number), shown(row.length, true, reading?.length, null))}
      </td>
      <td role="cell" className="contour-tangent">
        {tangential && (
          <button
            type="button"
            className="button contour-t number"
            aria-pressed={row.tangent}
            aria-label={t.tangentOf(number)}
            title={t.tangentOf(number)}
            onClick={() => onChange({ tangent: !row.tangent }, null)}
          >
            T
          </button>
        )}
      </td>
      <td role="cell" className="contour-words">
        {(row.kind === "UDC" || row.kind === "GRV") && (
          <RecessFields
            row={row}
            number={number}
            language={language}
            describedBy={`${id}-wrong`}
            place={undercut}
            isNew={isNew}
            onChange={onChange}
          />
        )}
      </td>
      <td role="cell" className="contour-wrong" id={`${id}-wrong`}>
        {(reading?.choices ?? 1) > 1 && (
          <button
            type="button"
            className="button small contour-second"
            aria-pressed={row.second}
            aria-label={t.secondOf(number)}
            onClick={() => onChange({ second: !row.second }, null)}
          >
            {t.secondShort}
          </button>
        )}
        <RowNotes row={row} number={number} language={language} />
        {open > 0 && <p className="small contour-open">{t.freedom(open)}</p>}
        {issues
          .filter(({ issue }) => open === 0 || issue.code !== "elementFree")
          .map((found, i) => (
            <Message key={i} as="div" tone={found.issue.severity} className="small">
              <p>
                <Unbroken text={issueText(all, language, found.issue, null)} />
              </p>
              {(found.field === "x" || found.field === "z" || found.field === "r") && (
                <TypedTolerance issue={found.issue} onTake={takeInto(found.field)} />
              )}
            </Message>
          ))}
      </td>
    </tr>
  );
}
