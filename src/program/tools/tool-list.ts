import { issue, type Issue } from "../../kernel/plan/issue.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { ShopTools } from "./read-tools.ts";
import { shippedTools } from "./shipped-tools.ts";
import { COLUMN_RULES, HOLDER_CELLS } from "./tool-columns.ts";
import {
  cellOf,
  entryOf,
  readEntry,
  type EntryReading,
  type MillTool,
  type TableLine,
  type ToolEntry,
} from "./tool-entry.ts";

/** All rows of the table, in its order. */
export type ToolList = readonly ToolEntry[];

/** Reading of a table: callable tools, refused ones with reasons, and the reading of each row by its id. */
export interface ToolListReading {
  readonly table: ShopTools;
  /** The milling tools of the table with all their columns. */
  readonly mills: readonly MillTool[];
  readonly rows: ReadonlyMap<string, EntryReading>;
}

/** The table that every installation starts with. */
export const shippedList: ToolList = shippedTools.map((tool) => entryOf(tool, `r${tool.T}`));

/** A free row id. */
export function newId(list: ToolList): string {
  const taken = new Set(list.map((entry) => entry.id));
  let n = list.length + 1;
  while (taken.has(`r${n}`)) n++;
  return `r${n}`;
}

/** Lowest free whole number above `from`. */
export function freeNumber(list: ToolList, from = 0): number {
  const taken = new Set(list.map((entry) => readOnce(entry).number));
  let n = Math.floor(from) + 1;
  while (taken.has(n)) n++;
  return n;
}

/** Away from its row an issue must name its column. */
function naming(found: Issue): Issue {
  if (found.code === "toolName") return found;
  const held = HOLDER_CELLS.some((cell) => cell === found.at);
  const column = held ? `holder.${found.at}` : (found.at ?? "T");
  const data = found.code === "toolColumn" ? found.data : { value: null };
  return issue("toolColumn", "error", { ...data, column }, held ? "tool" : found.at);
}

const known = new WeakMap<ToolEntry, EntryReading>();

/** Reads a row, cached per state. */
function readOnce(entry: ToolEntry): EntryReading {
  const before = known.get(entry);
  if (before) return before;
  const made = readEntry(entry);
  known.set(entry, made);
  return made;
}

/**
 * Reads every row. Of two rows with one number the first keeps it, and both are reported: either may be the one to
 * change.
 */
export function readList(list: ToolList): ToolListReading {
  const rows = new Map<string, EntryReading>();
  const tools: Tool[] = [];
  const mills: MillTool[] = [];
  const refused = new Map<number, readonly Issue[]>();
  const taken = new Set<number>();
  const numbers = new Map<number, number>();
  const readings = list.map(readOnce);
  for (const { number } of readings) if (number !== null) numbers.set(number, (numbers.get(number) ?? 0) + 1);
  list.forEach((entry, i) => {
    const reading = readings[i] as EntryReading;
    const { number, tool, mill, issues } = reading;
    if (number === null || numbers.get(number) === 1) rows.set(entry.id, reading);
    else {
      let nearest = Math.floor(number) + 1;
      while (numbers.has(nearest)) nearest++;
      const first = !taken.has(number);
      const twice = issue(
        "toolNumberTwice",
        first ? "warning" : "error",
        {
          number,
          ...(nearest <= COLUMN_RULES.T.range[1] && { nearest }),
        },
        "T",
      );
      rows.set(entry.id, { tool: first ? tool : null, mill: first ? mill : null, number, issues: [twice, ...issues] });
      if (!first) return;
    }
    if (number === null) return;
    taken.add(number);
    if (tool) tools.push(tool);
    else if (mill) mills.push(mill);
    else refused.set(number, issues.filter((each) => each.severity === "error").map(naming));
  });
  return { table: { tools, refused, ...(mills.length > 0 && { mills }) }, mills, rows };
}

/**
 * Merges rows of a file into the table: equal numbers are replaced, others appended. `lines`: source line of each row
 * in a table of the control.
 */
export function mergedTools(
  list: ToolList,
  rows: readonly ToolEntry["cells"][],
  lines: readonly (TableLine | undefined)[] = [],
): { readonly list: ToolList; readonly replaced: number; readonly added: number } {
  const next = [...list];
  const places = new Map<number, number>();
  list.forEach((entry, i) => {
    const { number } = readOnce(entry);
    if (number !== null && !places.has(number)) places.set(number, i);
  });
  const ids = new Set(list.map((entry) => entry.id));
  let replaced = 0;
  let n = list.length;
  for (const [i, cells] of rows.entries()) {
    const { number } = readEntry({ id: "", cells });
    const line = lines[i];
    const at = number === null ? undefined : places.get(number);
    const old = at === undefined ? undefined : next[at];
    if (at !== undefined && old) {
      next[at] = { ...old, cells, ...(line && { line }) };
      if (at < list.length) replaced++;
      continue;
    }
    do n++;
    while (ids.has(`r${n}`));
    if (number !== null) places.set(number, next.length);
    next.push({ id: `r${n}`, cells, ...(line && { line }) });
  }
  const added = next.length - list.length;
  return { list: next, replaced, added };
}

const sameLine = ({ line: a }: ToolEntry, { line: b }: ToolEntry) =>
  a === b || (a?.at === b?.at && a?.origin.name === b?.origin.name && a?.origin.text === b?.origin.text);

/** Whether two tables have the same cells in the same rows, regardless of ids. */
export const sameList = (a: ToolList, b: ToolList): boolean =>
  a === b ||
  (a.length === b.length &&
    a.every((entry, i) => {
      const other = b[i] as ToolEntry;
      return (
        entry === other ||
        (sameLine(entry, other) &&
          [...new Set([...Object.keys(entry.cells), ...Object.keys(other.cells)])].every(
            (cell) =>
              cellOf(entry, cell as keyof ToolEntry["cells"]) === cellOf(other, cell as keyof ToolEntry["cells"]),
          ))
      );
    }));

/** A row without its source file, which stays on this device. */
const bareRow = (entry: ToolEntry): ToolEntry => (entry.line ? { id: entry.id, cells: entry.cells } : entry);

/**
 * Rows matched by calls, in order: by number without index, or by name. Every row where `calls` is null. They are
 * exported with a job, without their source files.
 */
export function rowsCalled(list: ToolList, calls: readonly (number | string)[] | null): ToolList {
  if (calls === null) return list.map(bareRow);
  const numbers = new Set(
    calls.flatMap((call) => (Number.isFinite(Number(call)) ? [Number(call), Math.floor(Number(call))] : [])),
  );
  const names = new Set(calls.map((call) => String(call).trim().toUpperCase()));
  return list
    .filter((entry) => {
      const { number } = readOnce(entry);
      return (number !== null && numbers.has(number)) || names.has(cellOf(entry, "NAME").trim().toUpperCase());
    })
    .map(bareRow);
}
