import { memo, useEffect, useRef, type KeyboardEvent } from "react";
import { formatNumber } from "../../i18n/number.ts";
import {
  applies,
  LIMIT_CELLS,
  MILL_TABLE,
  POINT_LENGTH,
  ruleOf,
  TOOL_COLUMNS,
  type MillColumn,
  type ToolColumn,
} from "../../program/tools/tool-columns.ts";
import { cellOf, type EntryReading, type ToolEntry } from "../../program/tools/tool-entry.ts";
import type { ToolListReading } from "../../program/tools/tool-list.ts";
import { anyNumber, readText } from "../../program/values/field.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { InsertDrawing } from "../../app/pictures/lathe/InsertDrawing.tsx";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { drillOf } from "../../program/tools/drill-of.ts";
import { openToolRow, type ToolKind } from "../../app/place/place.ts";
import { useToolName } from "../../app/document/tool-name.ts";

/** Edge length of an insert in its row, px. */
const DRAWING = 28;
/** A longer table has no drawings in its rows, to stay fast. */
const MOST_DRAWN = 150;

type Column = ToolColumn | MillColumn | (typeof LIMIT_CELLS)[number] | typeof POINT_LENGTH;
/** Columns beside those of the control: shown as soon as a row fills one. */
const BESIDE: Readonly<Record<ToolKind, readonly Column[]>> = { turning: LIMIT_CELLS, milling: [POINT_LENGTH] };

/** Columns after the two that name the row. */
const COLUMNS: Readonly<Record<ToolKind, readonly Column[]>> = {
  turning: TOOL_COLUMNS.filter((column) => column !== "T" && column !== "NAME"),
  milling: ["TYPE", ...MILL_TABLE],
};
const WITH_LIMITS: typeof COLUMNS = {
  turning: [...COLUMNS.turning, ...BESIDE.turning],
  milling: [...COLUMNS.milling, ...BESIDE.milling],
};

/** A number in the format of the screen language; other text as typed. */
function useShown(): (column: Column, text: string) => string {
  const language = useSettings((s) => s.language);
  return (column, text) => {
    if (column === "NAME" || column === "TYPE" || column === "SUPPORT") return text;
    const { value } = readText(anyNumber, text);
    return value === null ? text : formatNumber(language, value, ruleOf(column).decimals);
  };
}

const ToolRow = memo(function ToolRow({
  entry,
  reading,
  columns,
  open,
  drawn,
}: {
  readonly entry: ToolEntry;
  readonly reading: EntryReading;
  readonly columns: readonly Column[];
  readonly open: boolean;
  readonly drawn: boolean;
}) {
  const t = useTexts("tables").tools;
  const name = useToolName()(entry);
  const shown = useShown();
  const type = cellOf(entry, "TYPE");
  const cutter = reading.tool ?? (reading.mill && drillOf(reading.mill));
  const wrong = new Set(reading.issues.filter((issue) => issue.severity === "error").map((issue) => issue.at));
  return (
    <tr className={open ? "open" : ""} onClick={() => openToolRow(entry.id)}>
      <th scope="row" className={wrong.has("T") || wrong.has("NAME") ? "wrong" : ""}>
        <button
          type="button"
          data-row={entry.id}
          tabIndex={open ? 0 : -1}
          aria-current={open ? "true" : undefined}
          aria-label={`${t.select(name)}${wrong.size > 0 ? `, ${t.hasError}` : ""}`}
        >
          {drawn && (
            <span className="row-insert">
              {cutter ? (
                <InsertDrawing tool={cutter} width={DRAWING} height={DRAWING} />
              ) : (
                !reading.mill && <Icon name="error" />
              )}
            </span>
          )}
          <b className="number">{cellOf(entry, "T")}</b>
          <span className="row-name number">{cellOf(entry, "NAME")}</span>
          {wrong.size > 0 && !drawn && <Icon name="error" />}
        </button>
      </th>
      {columns.map((column) => {
        const unused = !applies(column, type);
        const text = cellOf(entry, column);
        return (
          <td
            key={column}
            className={`number${unused ? " unused" : ""}${wrong.has(column) ? " wrong" : ""}${column === "TYPE" ? " word" : ""}`}
          >
            {text.trim() === "" ? (unused ? "–" : "") : shown(column, text)}
          </td>
        );
      })}
    </tr>
  );
});

/** The whole table; the open row is edited next to it. Arrow keys move between rows. */
export function ToolGrid({
  list,
  kind,
  read,
  open,
}: {
  /** The rows of this kind. */
  readonly list: readonly ToolEntry[];
  readonly kind: ToolKind;
  readonly read: ToolListReading;
  readonly open: string | null;
}) {
  const t = useTexts("tables").tools;
  const box = useRef<HTMLDivElement>(null);
  const at = list.findIndex((entry) => entry.id === open);
  const limited = list.some((entry) => BESIDE[kind].some((cell) => cellOf(entry, cell) !== ""));
  const columns = (limited ? WITH_LIMITS : COLUMNS)[kind];

  useEffect(() => {
    box.current?.querySelector<HTMLElement>("tr.open")?.scrollIntoView?.({ block: "nearest" });
  }, [open]);

  const onKeyDown = (event: KeyboardEvent) => {
    const ways: Readonly<Record<string, number>> = {
      ArrowDown: at + 1,
      ArrowUp: at - 1,
      Home: 0,
      End: list.length - 1,
    };
    const to = ways[event.key];
    const next = to === undefined ? undefined : list[to];
    if (!next) return;
    event.preventDefault();
    openToolRow(next.id);
    box.current?.querySelector<HTMLElement>(`button[data-row="${next.id}"]`)?.focus();
  };
  return (
    <div className="tool-grid" ref={box} onKeyDown={onKeyDown}>
      <table aria-label={kind === "milling" ? t.millTable : t.table}>
        <thead>
          <tr>
            <th scope="col" title={t.columns.T}>
              T <span className="soft">NAME</span>
            </th>
            {columns.map((column) => (
              <th
                key={column}
                scope="col"
                className={column === "TYPE" ? "word" : undefined}
                title={t.field(
                  column,
                  kind === "milling" && column === "T-ANGLE" ? t.drillAngle : { ...t.columns, ...t.limits }[column],
                )}
              >
                {column}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {list.map((entry) => {
            const reading = read.rows.get(entry.id);
            return (
              reading && (
                <ToolRow
                  key={entry.id}
                  entry={entry}
                  reading={reading}
                  columns={columns}
                  open={entry.id === open}
                  drawn={list.length <= MOST_DRAWN}
                />
              )
            );
          })}
        </tbody>
      </table>
    </div>
  );
}
