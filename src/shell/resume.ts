import { begin } from "../app/document/store.ts";
import { findWorks, readWork, type Kept } from "../app/records/device.ts";
import { showElsewhere } from "../app/place/place.ts";
import { notice } from "../app/base/notices.ts";
import { claimPatiently, keepState, noteWritten, unkeptWorks, useKeeping } from "../app/records/keep.ts";
import { readSave } from "../app/records/save-file.ts";
import { leaveBehind, leftBehind, rememberedWork, rememberWork } from "../app/records/tab.ts";

/** Saves what the previous page could not save in time; what still cannot be saved is left for the next page. */
async function catchUp(): Promise<void> {
  for (const { work, file: raw } of leftBehind()) {
    const file = readSave(raw);
    const kept = file && (await readWork(work));
    if (file && (!kept || kept.savedAt <= file.savedAt)) await keepState(work, file.job);
  }
  if (unkeptWorks().length === 0) leaveBehind([]);
}

/** The work requested by the address: its key, null for the start page; undefined if the address names none. */
export type AskedWork = string | null | undefined;

/** The first work to open: the requested one, the one last open in this tab, or the newest in a new tab. */
function firstWork(asked: AskedWork, works: readonly Kept[]): Kept | undefined {
  const remembered = asked === undefined ? rememberedWork() : (asked ?? "");
  if (remembered === null) return works[0];
  const found = works.find((w) => w.work === remembered);
  if (!found && asked) notice("workNotHere");
  if (!found) rememberWork(null);
  return found;
}

/** Opens the requested work, the one last open in this tab, the newest in a new tab, or the start page. Never fails. */
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
