import { create } from "zustand";
import { begin, open, useEditor } from "../store.ts";
import type { Work } from "../work.ts";
import { findWorks, keepWork, readWork, type Kept } from "./device.ts";
import { readSave, SAVE_VERSION } from "./save-file.ts";
import { claimWork, leaveBehind, newWorkName, rememberedWork, rememberWork, takeBehind } from "./tab.ts";

/** What the page says about saving. */
export interface Keeping {
  /** Works on this device, newest first. */
  readonly works: readonly Kept[];
  readonly notices: readonly ("notKept" | "copyOfOtherTab" | "engineFailed" | "linkDamaged" | "linkTooLarge" | "fileTooLarge" | "fileUnreadable" | "toolsDamaged" | "toolsNotKept")[];
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
let waiting: { readonly work: string; readonly job: Work } | null = null;
let writing = false;

/** Writes what waits; while one write runs only the newest state waits. */
async function write(): Promise<void> {
  if (writing) return;
  writing = true;
  while (waiting) {
    const { work, job } = waiting;
    waiting = null;
    written.set(work, job);
    if (!(await keepWork(work, job))) notice("notKept");
  }
  writing = false;
}

/** Rest before writing, so that writing never delays the picture of what is typed, ms. */
const REST = 80;

/** What hands over changes that it still holds back, before the page goes away. */
export const beforeLeaving = new Set<() => void>();

/** From now on each change of the work is kept on the device, a moment after it was made. */
export function startKeeping(): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let known: string | null | undefined;
  const stop = useEditor.subscribe(({ job: prompts, program, work }) => {
    const job = prompts ?? program;
    const name = job ? work : null;
    if (name !== known) rememberWork(name);
    known = name;
    if (!job || !work || written.get(work) === job) return;
    if (waiting && waiting.work !== work) void keepWork(waiting.work, waiting.job);
    waiting = { work, job };
    timer ??= setTimeout(() => {
      timer = undefined;
      void write();
    }, REST);
  });
  const rest = () => {
    for (const hand of beforeLeaving) hand();
    void write();
  };
  const leave = () => {
    for (const hand of beforeLeaving) hand();
    if (!waiting) return;
    leaveBehind(waiting.work, { version: SAVE_VERSION, savedAt: Date.now(), job: waiting.job });
    void write();
  };
  addEventListener("pagehide", leave);
  document.addEventListener("visibilitychange", rest);
  return () => {
    stop();
    clearTimeout(timer);
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
  const copy = newWorkName();
  await claimWork(copy);
  written.set(copy, job);
  notice("copyOfOtherTab");
  return copy;
}

/** Writes what the page before could not write in time. */
async function catchUp(): Promise<void> {
  const behind = takeBehind();
  const file = behind && readSave(behind.file);
  if (!behind || !file) return;
  const kept = await readWork(behind.work);
  if (!kept || kept.savedAt <= file.savedAt) await keepWork(behind.work, file.job);
}

/** Opens what this tab had open, or the newest work in a new tab, or the start page. Never fails. */
export async function resume(): Promise<void> {
  await catchUp();
  const found = await findWorks();
  useKeeping.setState({ works: found.works, damaged: found.setAside });
  if (!found.available) notice("notKept");
  const remembered = rememberedWork();
  const last = remembered === "" ? undefined : remembered === null ? found.works[0] : found.works.find((w) => w.work === remembered);
  if (last) begin(last.file.job, await nameFor(last.work, last.file.job));
  else begin(null, null);
  useKeeping.setState({ ready: true });
}

/** Begins new work under a name of its own; what was open stays on the device. */
export function startWork(job: Work): void {
  const work = newWorkName();
  rememberWork(work);
  void claimWork(work);
  open(job, work);
}

/** Opens a work of the list. */
export async function openWork(work: string): Promise<void> {
  const file = await readWork(work);
  if (file) open(file.job, await nameFor(work, file.job));
}

/** Reads the list again, for the start page. */
export async function refreshWorks(): Promise<void> {
  const found = await findWorks();
  useKeeping.setState((k) => ({ ...k, works: found.works, damaged: k.damaged + found.setAside }));
}
