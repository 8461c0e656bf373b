import { randomId } from "../base/random-id.ts";
import { time } from "../base/clock.ts";
import { create } from "zustand";
import { notice, withdraw } from "../base/notices.ts";
import { retryImport } from "../base/parts.ts";
import { increasing, oneAtATime } from "../base/once.ts";
import { TYPING } from "../base/waits.ts";
import { openFirstWork, flushEdits, open, openContent, useEditor } from "../document/store.ts";
import type { Work } from "../document/work.ts";
import {
  findWorks,
  forgetWork,
  keepWork,
  lookUpWork,
  readWork,
  summaryOf,
  type FoundWorks,
  type UnreadSave,
  type WorkSummary,
} from "./device.ts";
import {
  forgetJournal,
  journalWorks,
  leaveJournal,
  noteState,
  noteStored,
  readJournal,
  stateAfter,
  writeLarge,
  type Stored,
} from "./journal.ts";
import { forgetMark, noteOpening } from "./opening.ts";
import { onLateAnswer } from "../base/database.ts";
import { persistOnce } from "../base/persist.ts";
import { readSave, SAVE_VERSION } from "./save-file.ts";
import { showElsewhere } from "../place/place.ts";
import {
  answerRequests,
  requestWork,
  claimNew,
  claimWithRetries,
  claimWork,
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
  /** All saves that cannot be read. */
  readonly unread: readonly UnreadSave[];
  /** False until the device was read. */
  readonly ready: boolean;
}

export const useSavedWorks = create<SavedWorks>(() => ({ works: [], damaged: 0, unread: [], ready: false }));

/** Dismisses the notice about damaged saves. */
export const dismissDamaged = (): void => useSavedWorks.setState({ damaged: 0 });

/** Last saved state of each work, and the one that is being saved. */
const written = new Map<string, Stored>();
const writing = new Map<string, Stored>();
/** Records a state that was read from the device. */
export function noteWritten(work: string, stored: Stored): void {
  written.set(work, stored);
  noteState(work, stored.job, stored);
}
/** Last state of each work that could not be saved; it is retried, and can be downloaded. */
const unsaved = new Map<string, Work>();
export const unsavedWorks = (): readonly Work[] => [...unsaved.values()];
export const unsavedNames = (): readonly string[] => [...unsaved.keys()];
/**
 * Deletes a work with what is not saved of it. False if the device still has it: then nothing of it is lost. What only
 * this page has is gone in any case.
 */
export async function dropWork(work: string): Promise<boolean> {
  const [held, waiting, known] = [unsaved.get(work), pending.get(work), written.has(work)];
  // Nothing writes it again meanwhile.
  unsaved.delete(work);
  pending.delete(work);
  if (!(await forgetWork(work)) && known) {
    if (held) unsaved.set(work, held);
    if (waiting) pending.set(work, waiting);
    return false;
  }
  written.delete(work);
  forgetJournal(work);
  forgetMark(work);
  return true;
}

/** A later date than any before: the journal tells states apart by it. */
const nextDate = increasing(time);

const WHY = { full: "storageFull", refused: "notKept", silent: "storageSilent" } as const;

/**
 * Saves one state of a work. If that fails, it shows a notice and keeps the state in memory; where a newer edition has
 * saved the work meanwhile, the state becomes a work of its own.
 */
export async function keepState(work: string, job: Work): Promise<void> {
  const state = { savedAt: nextDate(), job };
  writing.set(work, state);
  const done = await keepWork(work, job, state.savedAt);
  writing.delete(work);
  const newest = pending.get(work) ?? job;
  if (done === "newer") {
    notice("newerWorks");
    forgetJournal(work);
    if (useEditor.getState().work === work) return continueWithCopy(openContent() ?? newest);
    return keepState(randomId(), newest);
  }
  if (done !== "kept") {
    unsaved.set(work, job);
    noteState(work, newest, written.get(work));
    return notice(WHY[done]);
  }
  written.set(work, state);
  noteStored(work, newest, state);
  persistOnce();
  if (!unsaved.delete(work) || unsaved.size > 0) return;
  for (const why of Object.values(WHY)) withdraw(why);
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
  const stored = free ? await readWork(work) : null,
    kept = stored?.job;
  const { fingerprint } = await retryImport(() => import("./difference.ts"));
  reclaiming.delete(work);
  const job = openContent();
  if (useEditor.getState().work !== work || !job) return;
  const isKnown = free && (!kept || !before || fingerprint(kept) === fingerprint(before.job));
  if (isKnown) {
    pending.set(work, job);
    wait();
  } else if (job !== first) continueWithCopy(job);
  else if (stored) {
    noteWritten(work, stored);
    openFirstWork(stored.job, work);
  } else closeForOtherTab(work, job, "isOpen");
}

/** Hands a work over to another tab: closes it here, and saves its newest state or returns it. */
async function handOverToTab(work: string): Promise<Work | null> {
  flushEdits();
  const job = openContent();
  if (job && useEditor.getState().work === work) {
    if (written.get(work)?.job !== job) pending.set(work, job);
    closeForOtherTab(work, job, "wasTaken");
  }
  while (pending.has(work)) await writePending();
  const state = unsaved.get(work) ?? null;
  unsaved.delete(work);
  forgetJournal(work);
  return state;
}

/** Another tab took a work because this one did not answer. Unsaved changes continue in a copy. */
function onTakenByTab(work: string): void {
  const job = openContent();
  const isOpen = useEditor.getState().work === work;
  pending.delete(work);
  leaveJournal(work);
  if (job && isOpen && written.get(work)?.job !== job) continueWithCopy(job);
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
    noteOpening(work);
    noteState(work, job, written.get(work), writing.get(work));
    // Undo and redo may return to a saved state while another one is pending.
    if (written.get(work)?.job === job && !pending.has(work)) return;
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
    writeLarge();
    void writePending();
  };
  // The browser asks before it closes a page with an unsaved work.
  const ask = (event: Event) => {
    flushEdits();
    if (unsaved.size > 0 || writeLarge().length > 0) event.preventDefault();
  };
  onLateAnswer(() => void refreshWorks());
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

/**
 * Starts a new work under a new name; the previous one stays saved. It is on the device before it is opened, so that
 * the next page can offer it should opening it break this one; only a large one takes time.
 */
export async function startWork(job: Work): Promise<void> {
  const work = randomId();
  rememberWork(work);
  claimNew(work);
  noteOpening(work);
  if (!noteState(work, job, undefined)) await keepState(work, job);
  open(job, work);
}

/** Newest state of a work, saved or not; null if there is none of this name. */
export async function newestState(work: string): Promise<Work | null> {
  const held = pending.get(work) ?? unsaved.get(work);
  if (held) return held;
  const stored = await readWork(work);
  if (stored && owns(work) && useEditor.getState().work !== work) noteWritten(work, stored);
  return stored?.job ?? null;
}

/** Saves what the journal of a page that ended has of a work. The tab has the lock of the work. */
async function settleJournal(work: string): Promise<void> {
  const entry = pending.has(work) || unsaved.has(work) ? null : readJournal(work);
  if (!entry) return;
  const found = await lookUpWork(work);
  if (found === "noAnswer") return;
  const stored = typeof found === "string" ? null : found;
  const job = stateAfter(entry, stored);
  if (!job) return forgetJournal(work);
  if (stored) written.set(work, stored);
  await keepState(found === "unreadable" ? randomId() : work, job);
}

/** The same for all works that no other tab has. */
export async function settleJournals(): Promise<void> {
  for (const work of journalWorks()) if (await claimWork(work)) await settleJournal(work);
}

/** Opens a saved work; false if there is none of this name. If another tab has it, a message is shown instead. */
export async function openWork(work: string): Promise<boolean> {
  const free = await claimWithRetries(work);
  if (free) await settleJournal(work);
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
  noteOpening(work);
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
  if (job) await startWork({ ...job, name: nameOf(job.name) });
}

/** Writes unsaved states and reads the list again, for the start page, where deleted works may have made room. */
export async function refreshWorks(): Promise<void> {
  await writePending();
  await retryUnsaved();
  showFound(await findWorks());
}

/** Shows what was found on the device, with the works that only this page has. */
export function showFound({ works, unread, setAside, available }: FoundWorks): void {
  const inMemory = [...unsaved].map(([work, job]) => summaryOf(work, { savedAt: time(), job }));
  useSavedWorks.setState((k) => {
    const listed = available ? works : k.works;
    const others = listed.filter(({ work }) => !unsaved.has(work));
    return {
      ...k,
      works: [...inMemory, ...others],
      damaged: k.damaged + setAside,
      unread: available ? unread : k.unread,
    };
  });
}
