import { z } from "zod/mini";
import { hasFile, tableOrigin } from "../../program/tools/tool-entry.ts";
import { sameList, shippedList, type ToolList } from "../../program/tools/tool-list.ts";
import { HOLDER_CELLS } from "../../program/tools/tool-columns.ts";
import { keepTable } from "../base/device-table.ts";
import { notice } from "../base/notices.ts";
import { toolRow } from "../document/tool-rows.ts";
import { takeTools, useTools } from "../document/tool-store.ts";

/*
 * The tool table is kept on the device as soon as it differs from the shipped one. All tabs share it: what one tab
 * changes the others take over.
 */
const VERSION = 2;
/** Tables of this version were kept before the shipped tools had holders. */
const WITHOUT_HOLDERS = 1;

/** Files that rows came from; a row names its file by the place in this list, and its line. */
const origin = z.object({ name: z.string(), text: z.string(), encoding: z.enum(["utf-8", "windows-1252"]) });
const row = z.extend(toolRow, { line: z.optional(z.tuple([z.number(), z.number()])) });
const file = z.object({
  version: z.union([z.literal(VERSION), z.literal(WITHOUT_HOLDERS)]),
  origins: z.optional(z.array(origin)),
  rows: z.array(row),
});

/** A table as plain data, each file that rows came from once. */
export function keptTable(list: ToolList): object {
  const origins = [...new Set(list.flatMap((entry) => (entry.line && hasFile(entry) ? entry.line.origin : [])))];
  const rows = list.map((entry) => ({
    id: entry.id,
    cells: entry.cells,
    ...(entry.line && hasFile(entry) && { line: [origins.indexOf(entry.line.origin), entry.line.at] }),
  }));
  const files = origins.map(({ name, text, encoding }) => ({ name, text, encoding }));
  return { version: VERSION, ...(files.length > 0 && { origins: files }), rows };
}

/** The text that is kept; null for the shipped table. */
export const writeKept = (list: ToolList): string | null => (sameList(list, shippedList) ? null : JSON.stringify(keptTable(list)));

/** A row as it was shipped but for its holder gets the holder; what was changed by hand stays as it is. */
function withShippedHolder(row: ToolList[number]): ToolList[number] {
  const held = (cell: string) => HOLDER_CELLS.some((each) => each === cell);
  const shipped = shippedList.find((each) => each.cells.T === row.cells.T);
  if (!shipped || Object.keys(row.cells).some(held)) return row;
  const bare = { ...shipped, cells: Object.fromEntries(Object.entries(shipped.cells).filter(([cell]) => !held(cell))) };
  return sameList([bare], [row]) ? { ...row, cells: shipped.cells } : row;
}

/** A kept table, or null when it is damaged. Never throws. */
export function readKept(text: string): ToolList | null {
  try {
    const read = file.safeParse(JSON.parse(text));
    if (!read.success) return null;
    const { version, rows: written } = read.data;
    const origins = (read.data.origins ?? []).map(({ name, text: whole, encoding }) => tableOrigin(name, whole, encoding));
    const kept: ToolList = written.map(({ id, cells: typed, line }) => {
      const from = line && origins[line[0]];
      return { id, cells: typed as ToolList[number]["cells"], ...(line && from && { line: { origin: from, at: line[1] } }) };
    });
    const rows = version === WITHOUT_HOLDERS ? kept.map(withShippedHolder) : kept;
    return new Set(rows.map((row) => row.id)).size === rows.length ? rows : null;
  } catch {
    return null;
  }
}

/** Reads the table of this device and keeps each change from now on. */
export const startTools = (): () => void =>
  keepTable<ToolList>({
    key: "turnwise/tools",
    aside: "turnwise/tools/damaged",
    store: useTools,
    first: shippedList,
    isSame: sameList,
    write: writeKept,
    read: readKept,
    take: takeTools,
    damaged: () => notice("toolsDamaged"),
    notKept: () => notice("toolsNotKept"),
  });
