import { begin } from "../app/document/store.ts";
import { findWorks, readWork, type Kept } from "../app/records/device.ts";
import { showElsewhere } from "../app/place/place.ts";
import { notice } from "../app/base/notices.ts";
import { claimPatiently, keepState, noteWritten, unkeptWorks, useKeeping } from "../app/records/keep.ts";
import { readSave } from "../app/records/save-file.ts";
import { leaveBehind, leftBehind, rememberedWork, rememberWork } from "../app/records/tab.ts";

/**
 * Writes what the page before could not write in time; what the device does not take stays behind for the next page.
 */
async function catchUp(): Promise<void> {
  for (const { work, file: raw } of leftBehind()) {
    const file = readSave(raw);
    const kept = file && (await readWork(work));
    if (file && (!kept || kept.savedAt <= file.savedAt)) await keepState(work, file.job);
  }
  if (unkeptWorks().length === 0) leaveBehind([]);
}

/**
 * What the page's address asks to be opened: a work by its name, null for the start page; undefined where it says
 * nothing of it.
 */
export type AskedWork = string | null | undefined;

/** The work to begin with: the one that is asked for, what this tab had open, or the newest one in a new tab. */
function firstWork(asked: AskedWork, works: readonly Kept[]): Kept | undefined {
  const remembered = asked === undefined ? rememberedWork() : (asked ?? "");
  if (remembered === null) return works[0];
  const found = works.find((w) => w.work === remembered);
  if (!found && asked) notice("workNotHere");
  if (!found) rememberWork(null);
  return found;
}

/**
 * Opens what was asked for, what this tab had open, or the newest work in a new tab, or the start page. Never fails.
 */
export async function resume(asked: AskedWork = undefined): Promise<void> {
  await catchUp();
  const found = await findWorks();
  useKeeping.setState({ works: found.works, damaged: found.setAside });
  if (!found.available) notice("notKept");
  if (found.newer > 0) notice("newerWorks");
  const last = firstWork(asked, found.works);
  const free = last !== undefined && (await claimPatiently(last.work));
  const file = free && (await readWork(last.work));
  if (last && file) {
    noteWritten(last.work, file.job);
    rememberWork(last.work);
    begin(file.job, last.work);
  } else begin(null, null);
  if (last && !free) showElsewhere({ work: last.work, name: last.name, cause: "isOpen" });
  useKeeping.setState({ ready: true });
}
