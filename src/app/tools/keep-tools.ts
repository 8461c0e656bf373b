import { z } from "zod/mini";
import { sameList, shippedList, type ToolList } from "../../program/tool-list.ts";
import { HOLDER_CELLS, MILL_COLUMNS, TOOL_COLUMNS } from "../../program/tool-columns.ts";
import { notice } from "../saving/keep.ts";
import { takeTools, useTools } from "./tool-store.ts";

/*
 * The tool table is kept on the device as soon as it differs from the shipped one. All tabs share it: what one tab
 * changes the others take over.
 */
const KEY = "turnwise/tools";
const ASIDE = "turnwise/tools/damaged";
const VERSION = 2;
/** Tables of this version were kept before the shipped tools had holders. */
const WITHOUT_HOLDERS = 1;

const cellText = z.string().check(z.maxLength(500));
const cells = z.partialRecord(z.enum([...TOOL_COLUMNS, ...MILL_COLUMNS, ...HOLDER_CELLS]), cellText);
const file = z.object({
  version: z.union([z.literal(VERSION), z.literal(WITHOUT_HOLDERS)]),
  rows: z.array(z.object({ id: cellText, cells })),
});

/** The text that is kept; null for the shipped table. */
export const writeKept =
  (list: ToolList): string | null => (sameList(list, shippedList) ? null : JSON.stringify({ version: VERSION, rows: list }));

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
    const { version, rows: kept } = read.data as { version: number; rows: ToolList };
    const rows = version === WITHOUT_HOLDERS ? kept.map(withShippedHolder) : kept;
    return new Set(rows.map((row) => row.id)).size === rows.length ? rows : null;
  } catch {
    return null;
  }
}

/** Takes over what the device holds. What cannot be read is set aside, and the shipped table stays. */
function take(kept: string | null): void {
  const list = kept === null ? shippedList : readKept(kept);
  if (list) {
    if (!sameList(list, useTools.getState().list)) takeTools(list);
    return;
  }
  notice("toolsDamaged");
  try {
    localStorage.setItem(ASIDE, kept ?? "");
    localStorage.removeItem(KEY);
  } catch {
    return;
  }
}

/** Rest before writing, ms. */
const REST = 80;

/** Reads the table of this device and keeps each change from now on. */
export function startTools(): () => void {
  try {
    take(localStorage.getItem(KEY));
  } catch {
    return () => undefined;
  }
  let timer: ReturnType<typeof setTimeout> | undefined;
  let written = useTools.getState().list;
  const write = () => {
    clearTimeout(timer);
    timer = undefined;
    const { list } = useTools.getState();
    if (list === written) return;
    written = list;
    try {
      const kept = writeKept(list);
      if (kept === null) localStorage.removeItem(KEY);
      else localStorage.setItem(KEY, kept);
    } catch {
      notice("toolsNotKept");
    }
  };
  const fromOtherTab = (event: StorageEvent) => {
    if (event.storageArea !== localStorage || (event.key !== KEY && event.key !== null)) return;
    take(event.newValue);
    written = useTools.getState().list;
  };
  const stop = useTools.subscribe(() => {
    timer ??= setTimeout(write, REST);
  });
  addEventListener("storage", fromOtherTab);
  addEventListener("pagehide", write);
  document.addEventListener("visibilitychange", write);
  return () => {
    write();
    stop();
    removeEventListener("storage", fromOtherTab);
    removeEventListener("pagehide", write);
    document.removeEventListener("visibilitychange", write);
  };
}
