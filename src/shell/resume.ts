import { openFirstWork } from "../app/document/store.ts";
import { findWorks, readWork, type WorkSummary } from "../app/records/device.ts";
import { showElsewhere } from "../app/place/place.ts";
import { notice } from "../app/base/notices.ts";
import { claimWithRetries, keepState, noteWritten, unsavedWorks, useSavedWorks } from "../app/records/keep.ts";
import { readSave } from "../app/records/save-file.ts";
import { storePending, readPending, rememberedWork, rememberWork } from "../app/records/tab.ts";

/** Saves what the previous page could not save in time; what still cannot be saved is left for the next page. */
async function writeUnsaved(): Promise<void> {
  for (const { work, file: raw } of readPending()) {
    const file = readSave(raw);
    const kept = file && (await readWork(work));
    if (file && (!kept || kept.savedAt <= file.savedAt)) await keepState(work, file.job);
  }
  if (unsavedWorks().length === 0) storePending([]);
}

/** The work requested by the address: its key, null for the start page; undefined if the address names none. */
export type AskedWork = string | null | undefined;

/** The first work to open: the requested one, the one last open in this tab, or the newest in a new tab. */
function firstWork(asked: AskedWork, works: readonly WorkSummary[]): WorkSummary | undefined {
  const remembered = asked === undefined ? rememberedWork() : (asked ?? "");
  if (remembered === null) return works[0];
  const found = works.find((w) => w.work === remembered);
  if (!found && asked) notice("workNotHere");
  if (!found) rememberWork(null);
  return found;
}

/** Opens the requested work, the one last open in this tab, the newest in a new tab, or the start page. Never fails. */
export async function resume(asked: AskedWork = undefined): Promise<void> {
  await writeUnsaved();
  const found = await findWorks();
  useSavedWorks.setState({ works: found.works, damaged: found.setAside });
  if (!found.available) notice("notKept");
  if (found.newer > 0) notice("newerWorks");
  const last = firstWork(asked, found.works);
  const free = last !== undefined && (await claimWithRetries(last.work));
  const file = free && (await readWork(last.work));
  if (last && file) {
    noteWritten(last.work, file.job);
    rememberWork(last.work);
    openFirstWork(file.job, last.work);
  } else openFirstWork(null, null);
  if (last && !free) showElsewhere({ work: last.work, name: last.name, cause: "isOpen" });
  useSavedWorks.setState({ ready: true });
}
