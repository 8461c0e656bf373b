import { useId } from "react";
import type { ToolsTexts } from "../../i18n/en/tables/tools.ts";
import type { SheetTexts } from "../../i18n/tool-sheet-text.ts";
import { isLength, isRadius, valuesIn, type ColumnChoice } from "../../program/tool-sheets/assignment.ts";
import type { SheetCell } from "../../program/tool-sheets/column-words.ts";
import type { Sheet } from "../../program/tool-sheets/sheet.ts";
import {
  HOLDER_NUMBERS,
  isLimit,
  LIMIT_CELLS,
  POINT_LENGTH,
  type HolderNumber,
  type NumberColumn,
} from "../../program/tools/tool-columns.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** Values of a column that are shown as examples. */
const EXAMPLES = 3;

const GROUPS: readonly (readonly [keyof ToolsTexts["groups"], readonly SheetCell[]])[] = [
  ["name", ["T", "NAME", "TYPE", "CODE"]],
  ["tip", ["TO", "RS", "DRS"]],
  ["insert", ["T-ANGLE", "P-ANGLE", "CUTLENGTH", "CUTWIDTH", "DCW"]],
  ["limits", LIMIT_CELLS],
  ["mill", ["R", "DR", "L", "DL", "LCUTS", "PITCH", POINT_LENGTH]],
  ["setting", ["ZL", "XL", "DZL", "DXL", "DYL", "ORI"]],
  ["holder", HOLDER_NUMBERS],
];

/** The name of a meaning in a list: the column of the control with what it is. */
function nameOf(cell: SheetCell, t: ToolsTexts, w: SheetTexts): string {
  if (cell === "CODE") return w.code;
  if (HOLDER_NUMBERS.some((each) => each === cell)) return t.holder[cell as HolderNumber];
  const limits: Readonly<Record<string, string>> = t.limits;
  return `${cell} · ${isLimit(cell) || cell in t.limits ? (limits[cell] ?? "") : t.columns[cell as NumberColumn]}`;
}

/** How the lengths of a column are written: unit, and radius or diameter where a sheet may give either. */
function Reading({
  choice,
  title,
  words: { readings, reading },
  onChoose,
}: {
  readonly choice: ColumnChoice;
  readonly title: string;
  readonly words: SheetTexts;
  readonly onChoose: (choice: ColumnChoice) => void;
}) {
  const ways = isRadius(choice.cell) ? [false, true] : [false];
  const all = [false, true].flatMap((inch) => ways.map((diameter) => ({ inch, diameter })));
  return (
    <select
      className="select"
      aria-label={reading(title)}
      value={all.findIndex(({ inch, diameter }) => inch === choice.inch && diameter === choice.diameter)}
      onChange={(e) => onChoose({ ...choice, ...all[Number(e.currentTarget.value)] })}
    >
      {all.map(({ inch, diameter }, i) => {
        const unit = inch ? readings.inch : readings.mm;
        return (
          <option key={i} value={i}>
            {ways.length === 1 ? unit : diameter ? readings.diameter(unit) : readings.radius(unit)}
          </option>
        );
      })}
    </select>
  );
}

/** One column of a sheet with examples of its values, its meaning, and how its lengths are written. */
export function SheetColumn({
  sheet,
  at,
  choice,
  words: w,
  onChoose,
}: {
  readonly sheet: Sheet;
  readonly at: number;
  readonly choice: ColumnChoice | null;
  readonly words: SheetTexts;
  readonly onChoose: (choice: ColumnChoice | null) => void;
}) {
  const t = useTexts("tables").tools;
  const id = useId();
  const title = sheet.titles[at] || w.untitled(at + 1);
  const examples = [...new Set(valuesIn(sheet, at))].slice(0, EXAMPLES);
  return (
    <li className="sheet-column">
      <span id={id} className="sheet-title">
        <b>{title}</b>
        <span className="soft small">{examples.length > 0 ? w.examples(examples.join(" · ")) : w.noExamples}</span>
      </span>
      <select
        className="select"
        aria-label={w.meaning(title)}
        aria-describedby={id}
        value={choice?.cell ?? ""}
        onChange={(e) => {
          const cell = e.currentTarget.value as SheetCell | "";
          onChoose(cell === "" ? null : { cell, inch: choice?.inch ?? false, diameter: false });
        }}
      >
        <option value="">{w.unused}</option>
        {GROUPS.map(([group, cells]) => (
          <optgroup key={group} label={t.groups[group]}>
            {cells.map((cell) => (
              <option key={cell} value={cell}>
                {nameOf(cell, t, w)}
              </option>
            ))}
          </optgroup>
        ))}
      </select>
      {choice && isLength(choice.cell) && <Reading choice={choice} title={title} words={w} onChoose={onChoose} />}
    </li>
  );
}
