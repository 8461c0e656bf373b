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
const VERSION = 1;

const text = z.string().check(z.maxLength(500));
const cells = z.partialRecord(z.enum([...TOOL_COLUMNS, ...MILL_COLUMNS, ...HOLDER_CELLS]), text);
const file = z.object({ version: z.literal(VERSION), rows: z.array(z.object({ id: text, cells })) });

/** The text that is kept; null for the shipped table. */
export const writeKept = (list: ToolList): string | null => (sameList(list, shippedList) ? null : JSON.stringify({ version: VERSION, rows: list }));

/** A kept table, or null when it is damaged. Never throws. */
export function readKept(kept: string): ToolList | null {
  try {
    const read = file.safeParse(JSON.parse(kept));
    if (!read.success) return null;
    const { rows } = read.data as { rows: ToolList };
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
