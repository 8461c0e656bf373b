import { useId, useRef } from "react";
import type { ToolsTexts } from "../../i18n/en/tables/tools.ts";
import type { Issue } from "../../kernel/plan/issue.ts";
import { sumOf } from "../../program/values/field.ts";
import type { HolderNumber, NumberColumn } from "../../program/tools/tool-columns.ts";
import { isDrillType, ruleOf } from "../../program/tools/tool-columns.ts";
import { cellOf, type ToolEntry } from "../../program/tools/tool-entry.ts";
import { FieldMessage } from "../../app/fields/dialog/FieldMessage.tsx";
import { useNumberEntry } from "../../app/fields/dialog/use-number-entry.ts";
import { inScreenWriting } from "../../app/fields/dialog/write-value.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { setCell } from "./tool-edits.ts";
import { closeStep } from "../../app/document/steps.ts";

/** What is wrong with a cell, read out when it changes. An empty cell that is needed is said calmly. */
export function CellMessages({ id, issues, text, onTake, decimals = 4 }: { readonly id: string; readonly issues: readonly Issue[];
  readonly text: string; readonly decimals?: number; readonly onTake?: (nearest: number) => void })
{
  return (
    <div id={id} className="tool-wrong" role="status">
      {issues.map((issue) => (
        <FieldMessage key={issue.code} problem={{ issue }} decimals={decimals} calm={text.trim() === "" && issue.severity === "error"}
          {...(onTake && { onTake })} />
      ))}
    </div>
  );
}

const UNITS = { length: "mm", angle: "degrees", number: null } as const;

/** What a column means for tools of one type alone. */
function ownMeaning(t: ToolsTexts, cell: NumberColumn | HolderNumber, type: string): string | null {
  if (cell === "T-ANGLE" && isDrillType(type)) return t.drillAngle;
  return cell === "CUTLENGTH" && type === "THREAD" ? t.toothHeight : null;
}

/** One number of a row: typed text goes to the table at each keystroke, sums are worked out when the field is left. */
export function ToolField({ entry, cell, issues, unused = null }: {
  readonly entry: ToolEntry;
  readonly cell: NumberColumn | HolderNumber;
  readonly issues: readonly Issue[];
  /** The type that has no use for this column; null when it has. */
  readonly unused?: string | null;
}) {
  const t = useTexts("tables").tools;
  const id = useId();
  const input = useRef<HTMLInputElement>(null);
  const language = useSettings((s) => s.language);
  const text = cellOf(entry, cell);
  const put = (next: string) => setCell(entry.id, cell, next);
  const { onKeyDown, onTyped } = useNumberEntry(input, text, put);
  const { kind, range: [min], decimals } = ruleOf(cell, cellOf(entry, "TYPE"));
  const isHolder = cell in t.holder;
  const column = isHolder ? null : cell as NumberColumn;
  const meaning = ownMeaning(t, cell, cellOf(entry, "TYPE")) ?? (column ? t.columns[column] : t.holder[cell as HolderNumber]);
  const found = issues.filter((issue) => issue.at === cell);

  const commit = () => {
    const sum = sumOf(text);
    if (sum !== null) put(sum);
    closeStep();
  };

  return (
    <div className={`tool-field${unused === null ? "" : " unused"}`}>
      <label htmlFor={id}>
        {column && <b className="number">{column}</b>} <span className="soft small">{meaning}</span>
      </label>
      <span className="tool-value">
        <input id={id} ref={input} className="input number" type="text" data-number="words" inputMode="decimal" autoComplete="off"
          spellCheck={false} maxLength={200} aria-label={column ? t.field(column, meaning) : meaning} disabled={unused !== null}
          aria-invalid={found.some((issue) => issue.severity === "error")} aria-describedby={`${id}-unit ${id}-wrong`}
          value={inScreenWriting(language, text)} onBlur={commit} onKeyDown={min < 0 ? onKeyDown : undefined} onChange={(e) => {
          onTyped();
          put(e.currentTarget.value);
        }} />
        <span className="soft small tool-unit" id={`${id}-unit`}>
          {unused === null ? UNITS[kind] && t.units[UNITS[kind]] : t.unused(unused)}
        </span>
      </span>
      <CellMessages id={`${id}-wrong`} issues={found} text={text} decimals={decimals} onTake={(nearest) => {
        closeStep();
        put(String(nearest));
        closeStep();
      }} />
    </div>
  );
}
