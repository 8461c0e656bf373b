import { cellText, readJson } from "../files/bounded.ts";
import type { Holder, Tool } from "../../kernel/plan/tool.ts";
import { writeHead } from "./holder-cells.ts";
import {
  HOLDER_CELLS,
  LIMIT_CELLS,
  POINT_LENGTH,
  isDrillType,
  MILL,
  MILL_TABLE,
  TOOL_COLUMNS,
  type CellName,
} from "./tool-columns.ts";
import type { MillTool, ToolEntry } from "./tool-entry.ts";
import { readTableCsv } from "./tool-table-csv.ts";
import { readTableText, type TableFile } from "./tool-table-text.ts";
import { isMillRow, unknownToolKeys } from "./tool-keys.ts";

/**
 * Writes tools as the tools file of the `verify` command, one tool per line, milling tools last. Nothing is rounded.
 */
export function writeTableJson(tools: readonly Tool[], mills: readonly MillTool[] = []): string {
  const lines = tools.map((tool) => {
    const columns = [...TOOL_COLUMNS, ...LIMIT_CELLS]
      .filter((column) => tool[column] !== undefined)
      .map((column) => [column, tool[column]]);
    return `  ${JSON.stringify({ ...Object.fromEntries(columns), ...(tool.holder && { holder: tool.holder }) })}`;
  });
  lines.push(...mills.map(({ T, NAME, ...columns }) => `  ${JSON.stringify({ T, NAME, TYPE: MILL, ...columns })}`));
  return `{ "tools": [\n${lines.join(",\n")}\n] }\n`;
}

const isRecord = (value: unknown): value is Readonly<Record<string, unknown>> =>
  typeof value === "object" && value !== null && !Array.isArray(value);

/** A cell as text; other values become text that its column reports. */
const asText = (value: unknown): string => (typeof value === "string" ? value : (JSON.stringify(value) ?? ""));

/** Corners of a head as typed; other values become text that its cell reports. */
const isPair = (c: unknown) => Array.isArray(c) && c.length === 2 && c.every((n) => typeof n === "number");
const isHead = (value: unknown): value is NonNullable<Holder["head"]> =>
  Array.isArray(value) && value.every((part) => Array.isArray(part) && part.every(isPair));

function cellsOf(row: Readonly<Record<string, unknown>>): ToolEntry["cells"] {
  const cells: Partial<Record<CellName, string>> = {};
  const take = (name: CellName, value: unknown) => {
    if (value !== null && value !== undefined && value !== "") cells[name] = asText(value);
  };
  const isMill = isMillRow(row);
  const drill = String(row["TYPE"]).toUpperCase();
  if (isMill) cells.TYPE = isDrillType(drill) ? drill : MILL;
  const columns: readonly CellName[] = isMill
    ? ["T", "NAME", ...MILL_TABLE, POINT_LENGTH]
    : [...TOOL_COLUMNS, ...LIMIT_CELLS];
  for (const [name, value] of Object.entries(row)) {
    const column = columns.find((each) => each === name);
    if (column) take(column, value);
    else if (name === "holder" && isRecord(value) && !isMill) {
      for (const cell of HOLDER_CELLS)
        take(cell, cell === "head" && isHead(value[cell]) ? writeHead(value[cell]) : value[cell]);
    }
  }
  return cells;
}

/** Reads a tools file cell by cell, so that rows with a wrong cell are imported and shown. */
export function readTableJson(text: string): TableFile {
  let json: unknown;
  try {
    json = readJson(text);
  } catch {
    return { problem: "notATable" };
  }
  const tools = isRecord(json) ? json["tools"] : null;
  if (!Array.isArray(tools) || !tools.every(isRecord)) return { problem: "notATable" };
  if (tools.length === 0) return { problem: "noRows" };
  const unknown = unknownToolKeys(json).map(
    ({ at, key, nearest }) =>
      `${at.endsWith(".holder") ? "holder." : ""}${key}${nearest === null ? "" : ` (${nearest}?)`}`,
  );
  return { rows: tools.map(cellsOf), leftOut: [...new Set(unknown)], cutShort: false };
}

/** Most rows that a file may bring. */
export const MOST_ROWS = 2000;

/** JSON begins with a brace, a table of the control with BEGIN; anything else may be a sheet. */
function readKind(text: string): TableFile {
  const bare = text.replace(/^\uFEFF/, "").trimStart();
  if (/^[{[]/.test(bare)) return readTableJson(text);
  return /^BEGIN\s/i.test(bare) ? readTableText(text) : readTableCsv(text);
}

const shortCells = (cells: ToolEntry["cells"]): ToolEntry["cells"] =>
  Object.fromEntries(Object.entries(cells).map(([name, text]) => [name, cellText(text)]));

/** Reads a file of any kind. A cell that is longer than any is cut, so that its column reports it. Never throws. */
export function readToolFile(text: string): TableFile | { readonly problem: "tooMany"; readonly most: number } {
  const read = readKind(text);
  if (!("rows" in read)) return read;
  if (read.rows.length > MOST_ROWS) return { problem: "tooMany", most: MOST_ROWS };
  return { ...read, rows: read.rows.map(shortCells), leftOut: read.leftOut.slice(0, MOST_ROWS).map(cellText) };
}
