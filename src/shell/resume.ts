import { openFirstWork } from "../app/document/store.ts";
import { findWorks, readWork, type WorkSummary } from "../app/records/device.ts";
import { showElsewhere } from "../app/place/place.ts";
import { notice } from "../app/base/notices.ts";
import { keepState, noteWritten, settleJournals, showFound, useSavedWorks } from "../app/records/keep.ts";
import { isSilent } from "../app/base/database.ts";
import { diedOpen, noteOpening } from "../app/records/opening.ts";
import { readSave } from "../app/records/save-file.ts";
import { claimWithRetries, takePending, rememberedWork, rememberWork } from "../app/records/tab.ts";

/** Saves what the previous page could not save in time. */
async function writeUnsaved(): Promise<void> {
  for (const { work, file: raw } of takePending()) {
    const file = readSave(raw);
    const kept = file && (await readWork(work));
    if (file && (!kept || kept.savedAt <= file.savedAt)) await keepState(work, file.job);
  }
  await settleJournals();
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
  showFound(found);
  if (!found.available) {
    notice(isSilent() ? "storageSilent" : "notKept");
    // The work may be there: its address stays, and it opens once the storage answers.
    openFirstWork(null, null);
    return useSavedWorks.setState({ ready: true });
  }
  if (found.newer > 0) notice("newerWorks");
  const last = firstWork(asked, useSavedWorks.getState().works);
  const free = last !== undefined && (await claimWithRetries(last.work));
  // What was open when the page died may be the cause: it is offered, and opened only on request.
  const died = free && diedOpen(last.work);
  const file = free && !died && (await readWork(last.work));
  if (last && file) {
    noteOpening(last.work);
    noteWritten(last.work, file);
    rememberWork(last.work);
    openFirstWork(file.job, last.work);
  } else openFirstWork(null, null);
  if (last && (!free || died)) showElsewhere({ work: last.work, name: last.name, cause: died ? "died" : "isOpen" });
  useSavedWorks.setState({ ready: true });
}
