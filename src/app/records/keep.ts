import { randomId } from "../base/random-id.ts";
import { time } from "../base/clock.ts";
import { create } from "zustand";
import { notice, withdraw } from "../base/notices.ts";
import { retryImport } from "../base/parts.ts";
import { oneAtATime } from "../base/once.ts";
import { TYPING } from "../base/waits.ts";
import { openFirstWork, flushEdits, open, openContent, useEditor } from "../document/store.ts";
import type { Work } from "../document/work.ts";
import { findWorks, keepWork, readWork, type WorkSummary } from "./device.ts";
import { persistOnce } from "../base/persist.ts";
import { readSave, SAVE_VERSION } from "./save-file.ts";
import { showElsewhere } from "../place/place.ts";
import {
  answerRequests,
  requestWork,
  claimNew,
  claimWork,
  storePending,
  onLost,
  ownedWorks,
  owns,
  releaseWork,
  rememberWork,
  announceChange,
} from "./tab.ts";

/** State of saving. */
export interface SavedWorks {
  /** Works on this device, newest first. */
  readonly works: readonly WorkSummary[];
  /** Damaged saves that were set aside when the page opened. */
  readonly damaged: number;
  /** False until the device was read. */
  readonly ready: boolean;
}

export const useSavedWorks = create<SavedWorks>(() => ({ works: [], damaged: 0, ready: false }));

/** Dismisses the notice about damaged saves. */
export const dismissDamaged = (): void => useSavedWorks.setState({ damaged: 0 });

/** Last saved state of each work. */
const written = new Map<string, Work>();
/** Records a state that was read from the device. */
export const noteWritten = (work: string, job: Work): void => void written.set(work, job);
/** Last state of each work that could not be saved; it is retried, and can be downloaded. */
const unsaved = new Map<string, Work>();
export const unsavedWorks = (): readonly Work[] => [...unsaved.values()];
export const unsavedNames = (): readonly string[] => [...unsaved.keys()];
/** Drops an unsaved state. */
export const forgetUnsaved = (work: string): void => void unsaved.delete(work);

/** Saves one state of a work. If that fails, it shows a notice and keeps the state in memory. */
export async function keepState(work: string, job: Work): Promise<void> {
  const done = await keepWork(work, job);
  if (done !== "kept") {
    unsaved.set(work, job);
    return notice(done === "full" ? "storageFull" : "notKept");
  }
  written.set(work, job);
  persistOnce();
  if (!unsaved.delete(work) || unsaved.size > 0) return;
  withdraw("storageFull");
  withdraw("notKept");
}

/** Retries unsaved states when there may be space again. */
async function retryUnsaved(): Promise<void> {
  for (const [work, job] of [...unsaved]) await keepState(work, job);
}
/** Newest unsaved state of each work, including the one being written. */
const pending = new Map<string, Work>();

async function writeAll(): Promise<void> {
  for (let next = pending.entries().next(); !next.done; next = pending.entries().next()) {
    const [work, job] = next.value;
    await keepState(work, job);
    if (pending.get(work) === job) pending.delete(work);
  }
  // Saved works that are not open here are released for other tabs.
  const open = useEditor.getState().work;
  const done = ownedWorks().filter((work) => work !== open && !pending.has(work) && !unsaved.has(work));
  for (const work of done) releaseWork(work);
  if (done.length > 0) announceChange();
}

/** Writes pending states one by one. A state stays pending until written, since the page may close meanwhile. */
const writePending = oneAtATime(writeAll);

/** Continues with a copy under a new name, so that the work of the other tab is not overwritten. */
function continueWithCopy(job: Work): void {
  const copy = randomId();
  claimNew(copy);
  openFirstWork(job, copy);
  notice("copyOfOtherTab");
}

/** Closes a work that another tab has, and shows a message instead. */
function closeForOtherTab(work: string, job: Work, cause: "isOpen" | "wasTaken"): void {
  openFirstWork(null, null);
  showElsewhere({ work, name: job.name, cause });
}

const reclaiming = new Set<string>();

/** A work was opened while saving released it: claims it again, with its state on the device. */
async function reclaimReleased(work: string, first: Work, wait: () => void): Promise<void> {
  if (reclaiming.has(work)) return;
  reclaiming.add(work);
  const before = written.get(work);
  const free = await claimWork(work);
  const kept = free ? (await readWork(work))?.job : undefined;
  const { fingerprint } = await retryImport(() => import("./difference.ts"));
  reclaiming.delete(work);
  const job = openContent();
  if (useEditor.getState().work !== work || !job) return;
  const isKnown = free && (!kept || !before || fingerprint(kept) === fingerprint(before));
  if (isKnown) {
    pending.set(work, job);
    wait();
  } else if (job !== first) continueWithCopy(job);
  else if (kept) {
    written.set(work, kept);
    openFirstWork(kept, work);
  } else closeForOtherTab(work, job, "isOpen");
}

/** Hands a work over to another tab: closes it here, and saves its newest state or returns it. */
async function handOverToTab(work: string): Promise<Work | null> {
  flushEdits();
  const job = openContent();
  if (job && useEditor.getState().work === work) {
    if (written.get(work) !== job) pending.set(work, job);
    closeForOtherTab(work, job, "wasTaken");
  }
  while (pending.has(work)) await writePending();
  const state = unsaved.get(work) ?? null;
  unsaved.delete(work);
  return state;
}

/** Another tab took a work because this one did not answer. Unsaved changes continue in a copy. */
function onTakenByTab(work: string): void {
  const job = openContent();
  const isOpen = useEditor.getState().work === work;
  pending.delete(work);
  if (job && isOpen && written.get(work) !== job) continueWithCopy(job);
  else if (job && isOpen) closeForOtherTab(work, job, "wasTaken");
}

/** Starts saving each change of the work after a short delay. */
export function startAutosave(): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let known: string | null | undefined;
  const wait = () => {
    timer ??= setTimeout(() => {
      timer = undefined;
      void writePending();
    }, TYPING.keep);
  };
  const stop = useEditor.subscribe((editor) => {
    const job = openContent(editor),
      { work } = editor;
    const name = job ? work : null;
    if (name !== known) {
      rememberWork(name);
      wait();
    }
    known = name;
    if (!job || !work) return;
    if (!owns(work)) return void reclaimReleased(work, job, wait);
    // Undo and redo may return to a saved state while another one is pending.
    if (written.get(work) === job && !pending.has(work)) return;
    pending.set(work, job);
    wait();
  });
  const stopAnswering = answerRequests(handOverToTab);
  onLost.add(onTakenByTab);
  const rest = () => {
    flushEdits();
    void writePending();
  };
  const leave = () => {
    flushEdits();
    const savedAt = time();
    storePending(
      [...new Map([...unsaved, ...pending])].map(([work, job]) => ({
        work,
        file: { version: SAVE_VERSION, savedAt, job },
      })),
    );
    void writePending();
  };
  // The browser asks before it closes a page with an unsaved work.
  const ask = (event: Event) => {
    if (unsaved.size > 0) event.preventDefault();
  };
  addEventListener("beforeunload", ask);
  addEventListener("pagehide", leave);
  document.addEventListener("visibilitychange", rest);
  return () => {
    stop();
    stopAnswering();
    onLost.delete(onTakenByTab);
    clearTimeout(timer);
    removeEventListener("beforeunload", ask);
    removeEventListener("pagehide", leave);
    document.removeEventListener("visibilitychange", rest);
    void writePending();
  };
}

/** Attempts to claim a work, and the pause between them, ms: a tab that closes or reloads releases it late. */
const ASKING = { times: 5, rest: 60 };

/** Claims a work for this tab, with retries. */
export async function claimWithRetries(work: string): Promise<boolean> {
  for (let attempt = 0; attempt < ASKING.times; attempt++) {
    if (attempt > 0) await new Promise((done) => setTimeout(done, ASKING.rest));
    if (await claimWork(work)) return true;
  }
  return false;
}

/** Starts a new work under a new name; the previous one stays saved. */
export function startWork(job: Work): void {
  const work = randomId();
  rememberWork(work);
  claimNew(work);
  open(job, work);
}

/** Newest state of a work, saved or not; null if there is none of this name. */
export const newestState = async (work: string): Promise<Work | null> =>
  pending.get(work) ?? unsaved.get(work) ?? (await readWork(work))?.job ?? null;

/** Opens a saved work; false if there is none of this name. If another tab has it, a message is shown instead. */
export async function openWork(work: string): Promise<boolean> {
  const free = await claimWithRetries(work);
  const job = await newestState(work);
  if (!job) {
    await refreshWorks();
    return false;
  }
  if (!free) {
    open(null, null);
    showElsewhere({ work, name: job.name, cause: "isOpen" });
    return true;
  }
  if (!pending.has(work) && !unsaved.has(work)) written.set(work, job);
  open(job, work);
  return true;
}

/** Takes a work over from another tab: its newest state, or the saved one if that tab does not answer. */
export async function takeOver(work: string): Promise<boolean> {
  let given: unknown;
  if (!(await claimWork(work))) {
    given = await requestWork(work);
    if (!(await claimWithRetries(work)) && !(await claimWork(work, true))) return false;
  }
  const state = given ? readSave({ version: SAVE_VERSION, savedAt: 0, job: given })?.job : undefined;
  if (state) {
    open(state, work);
    return true;
  }
  return openWork(work);
}

/** Opens a copy of a work; the original stays unchanged. */
export async function copyWork(work: string, nameOf: (name: string) => string): Promise<void> {
  const job = await newestState(work);
  if (job) startWork({ ...job, name: nameOf(job.name) });
}

/** Writes unsaved states and reads the list again, for the start page, where deleted works may have made room. */
export async function refreshWorks(): Promise<void> {
  await writePending();
  await retryUnsaved();
  const found = await findWorks();
  useSavedWorks.setState((k) => ({ ...k, works: found.works, damaged: k.damaged + found.setAside }));
}
