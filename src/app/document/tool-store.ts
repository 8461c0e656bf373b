import { z } from "zod/mini";
import { whole } from "../../program/files/bounded.ts";
import { HOLDER_CELLS } from "../../program/tools/tool-columns.ts";
import { hasFile, tableOrigin } from "../../program/tools/tool-entry.ts";
import { readList, sameList, shippedList, type ToolList, type ToolListReading } from "../../program/tools/tool-list.ts";
import { notice } from "../base/notices.ts";
import { record } from "../base/record.ts";
import { uniqueIds } from "../base/unique.ts";
import { editRecord } from "./edit-record.ts";
import { forget } from "./steps.ts";
import { MOST_TOOLS, toolRow } from "./tool-rows.ts";

/** Imported files; a row refers to its file by the index in this list, and to its line. */
const origin = z.object({ name: z.string(), text: z.string(), encoding: z.enum(["utf-8", "windows-1252"]) });
const row = z.extend(toolRow, { line: z.optional(z.tuple([whole, whole])) });
const table = z.object({ origins: z.optional(z.array(origin)), rows: z.array(row).check(uniqueIds) });

/** A table as plain data, with each imported file once. */
function keptTable(list: ToolList): object {
  const origins = [...new Set(list.flatMap((entry) => (entry.line && hasFile(entry) ? entry.line.origin : [])))];
  const rows = list.map((entry) => ({
    id: entry.id,
    cells: entry.cells,
    ...(entry.line && hasFile(entry) && { line: [origins.indexOf(entry.line.origin), entry.line.at] }),
  }));
  const files = origins.map(({ name, text, encoding }) => ({ name, text, encoding }));
  return { ...(files.length > 0 && { origins: files }), rows };
}

function listOf(kept: z.output<typeof table>): ToolList {
  const origins = (kept.origins ?? []).map(({ name, text, encoding }) => tableOrigin(name, text, encoding));
  return kept.rows.map(({ id, cells, line }) => {
    const from = line && origins[line[0]];
    return {
      id,
      cells: cells as ToolList[number]["cells"],
      ...(line && from && { line: { origin: from, at: line[1] } }),
    };
  });
}

/** Adds the holder to an otherwise unchanged shipped row; a row changed by hand stays as it is. */
function withShippedHolder(row: ToolList[number]): ToolList[number] {
  const held = (cell: string) => HOLDER_CELLS.some((each) => each === cell);
  const shipped = shippedList.find((each) => each.cells.T === row.cells.T);
  if (!shipped || Object.keys(row.cells).some(held)) return row;
  const bare = { ...shipped, cells: Object.fromEntries(Object.entries(shipped.cells).filter(([cell]) => !held(cell))) };
  return sameList([bare], [row]) ? { ...row, cells: shipped.cells } : row;
}

/** The tool table of this device, as typed. All programs call its tools, except those with their own. */
export const toolRecord = record({
  key: "tools",
  version: 2,
  schema: table,
  rows: { of: "rows", each: row, most: MOST_TOOLS },
  // In tables of version 1 the shipped tools had no holders.
  upgrades: { 1: (list) => list.map(withShippedHolder) },
  from: listOf,
  to: keptTable,
  first: shippedList,
  isSame: sameList,
  undo: forget,
  say: (trouble) => notice(trouble === "damaged" ? "toolsDamaged" : "toolsNotKept"),
});
export const useTools = toolRecord.use;

const read = new WeakMap<ToolList, ToolListReading>();

/** The parsed table, cached per state. */
export function toolsOnDevice(list: ToolList): ToolListReading {
  const known = read.get(list);
  if (known) return known;
  const made = readList(list);
  read.set(list, made);
  return made;
}

/** Changes the table as one step of undo; successive changes at the same place are one step. */
export const editTools = (change: (list: ToolList) => ToolList, place: string | null = null): void =>
  editRecord(toolRecord, change, place);
