import { drawnId } from "../chance.ts";
import { time } from "../clock.ts";
import { create } from "zustand";
import { begin, handOver, open, useEditor } from "../store.ts";
import type { Work } from "../work.ts";
import { findWorks, forgetWork, keepWork, readWork, type Kept } from "./device.ts";
import { readSave, SAVE_VERSION } from "./save-file.ts";
import { claimWork, leaveBehind, leftBehind, rememberedWork, rememberWork } from "./tab.ts";

/** What the page says about saving. */
export interface Keeping {
  /** Works on this device, newest first. */
  readonly works: readonly Kept[];
  readonly notices:
    readonly ("notKept" | "storageFull" | "newerWorks" | "copyOfOtherTab" | "engineFailed" | "linkDamaged" | "linkTooLarge" | "linkNewer"
      | "fileTooLarge" | "fileUnreadable" | "mainUnsure" | "toolsDamaged" | "toolsNotKept" | "ownDamaged" | "ownNotKept" | "workNotHere")[];
  /** Damaged saves that were set aside when the page opened. */
  readonly damaged: number;
  /** False until the device was read. */
  readonly ready: boolean;
}

export const useKeeping = create<Keeping>(() => ({ works: [], notices: [], damaged: 0, ready: false }));

type Notice = Keeping["notices"][number];

export const notice = (which: Notice): void =>
  useKeeping.setState((k) => (k.notices.includes(which) ? k : { ...k, notices: [...k.notices, which] }));

export const dismiss = (which: Notice | "damaged"): void =>
  useKeeping.setState((k) => (which === "damaged" ? { ...k, damaged: 0 } : { ...k, notices: k.notices.filter((n) => n !== which) }));

/** The last state of each work that is already on the device. */
const written = new Map<string, Work>();
/** The last state of each work that the device did not take: it is tried again, and can be downloaded. */
const unkept = new Map<string, Work>();
export const unkeptWorks = (): readonly Work[] => [...unkept.values()];

/** Keeps one state of a work. What the device does not take is said and stays in memory. */
async function keep(work: string, job: Work): Promise<void> {
  const done = await keepWork(work, job);
  if (done !== "kept") {
    unkept.set(work, job);
    return notice(done === "full" ? "storageFull" : "notKept");
  }
  written.set(work, job);
  if (!unkept.delete(work) || unkept.size > 0) return;
  dismiss("storageFull");
  dismiss("notKept");
}

/** Tries again what the device did not take, when there may be room for it. */
async function keepAgain(): Promise<void> {
  for (const [work, job] of [...unkept]) await keep(work, job);
}
/** The newest state of each work that is not yet on the device, those that are being written among them. */
const waiting = new Map<string, Work>();
let writing = false;

/** Writes what waits, one work after the other. A state waits until it is written: the page may go away on the way. */
async function write(): Promise<void> {
  if (writing) return;
  writing = true;
  for (let next = waiting.entries().next(); !next.done; next = waiting.entries().next()) {
    const [work, job] = next.value;
    await keep(work, job);
    if (waiting.get(work) === job) waiting.delete(work);
  }
  writing = false;
}

/** Rest before writing, so that writing never delays the picture of what is typed, ms. */
const REST = 80;

/** From now on each change of the work is kept on the device, a moment after it was made. */
export function startKeeping(): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let known: string | null | undefined;
  const stop = useEditor.subscribe(({ job: prompts, program, work }) => {
    const job = prompts ?? program;
    const name = job ? work : null;
    if (name !== known) rememberWork(name);
    known = name;
    if (!job || !work) return;
    // Undo and redo come back to a state that was written, while another one waits or is on its way.
    if (written.get(work) === job && !waiting.has(work)) return;
    waiting.set(work, job);
    timer ??= setTimeout(() => {
      timer = undefined;
      void write();
    }, REST);
  });
  const rest = () => {
    handOver();
    void write();
  };
  const leave = () => {
    handOver();
    const savedAt = time();
    leaveBehind([...new Map([...unkept, ...waiting])].map(([work, job]) => ({ work, file: { version: SAVE_VERSION, savedAt, job } })));
    void write();
  };
  // The browser asks before it closes a page whose work is nowhere else.
  const ask = (event: Event) => {
    if (unkept.size > 0) event.preventDefault();
  };
  addEventListener("beforeunload", ask);
  addEventListener("pagehide", leave);
  document.addEventListener("visibilitychange", rest);
  return () => {
    stop();
    clearTimeout(timer);
    removeEventListener("beforeunload", ask);
    removeEventListener("pagehide", leave);
    document.removeEventListener("visibilitychange", rest);
    void write();
  };
}

/** Takes a saved work into this tab: its own name when it is free, a name for a copy when another tab has it open. */
async function nameFor(work: string, job: Work): Promise<string> {
  const patience = rememberedWork() === work ? 5 : 1;
  for (let attempt = 0; attempt < patience; attempt++) {
    if (attempt > 0) await new Promise((done) => setTimeout(done, 60));
    if (!(await claimWork(work))) continue;
    rememberWork(work);
    written.set(work, job);
    return work;
  }
  const copy = drawnId();
  await claimWork(copy);
  written.set(copy, job);
  notice("copyOfOtherTab");
  return copy;
}

/** Writes what the page before could not write in time; what the device does not take stays behind for the next page. */
async function catchUp(): Promise<void> {
  for (const { work, file: raw } of leftBehind()) {
    const file = readSave(raw);
    const kept = file && (await readWork(work));
    if (file && (!kept || kept.savedAt <= file.savedAt)) await keep(work, file.job);
  }
  if (unkept.size === 0) leaveBehind([]);
}

/** What the page's address asks to be opened: a work by its name, null for the start page; undefined where it says nothing of it. */
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

/** Opens what was asked for, what this tab had open, or the newest work in a new tab, or the start page. Never fails. */
export async function resume(asked: AskedWork = undefined): Promise<void> {
  await catchUp();
  const found = await findWorks();
  useKeeping.setState({ works: found.works, damaged: found.setAside });
  if (!found.available) notice("notKept");
  if (found.newer > 0) notice("newerWorks");
  const last = firstWork(asked, found.works);
  const file = last && (await readWork(last.work));
  if (last && file) begin(file.job, await nameFor(last.work, file.job));
  else begin(null, null);
  useKeeping.setState({ ready: true });
}

/** Begins new work under a name of its own; what was open stays on the device. */
export function startWork(job: Work): void {
  const work = drawnId();
  rememberWork(work);
  void claimWork(work);
  open(job, work);
}

/** Opens a work of this device, also one that the device did not take; false when there is none of this name. */
export async function openWork(work: string): Promise<boolean> {
  const job = waiting.get(work) ?? unkept.get(work) ?? (await readWork(work))?.job;
  if (!job) return false;
  open(job, await nameFor(work, job));
  return true;
}

/** Reads the list again, for the start page, where works may have been removed and room made. */
export async function refreshWorks(): Promise<void> {
  await keepAgain();
  const found = await findWorks();
  useKeeping.setState((k) => ({ ...k, works: found.works, damaged: k.damaged + found.setAside }));
}

/** Takes a work out of the list. Gives what it was, so that it can be put back; null when it was already gone. */
export async function removeWork(work: string): Promise<Work | null> {
  const job = unkept.get(work) ?? (await readWork(work))?.job ?? null;
  unkept.delete(work);
  await forgetWork(work);
  await refreshWorks();
  return job;
}

/** Puts a work back that was taken out of the list. */
export async function putBack(work: string, job: Work): Promise<void> {
  await keep(work, job);
  await refreshWorks();
}
