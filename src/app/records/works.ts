import { fileKey } from "../../program/state/program-files.ts";
import { randomId } from "../base/random-id.ts";
import { time } from "../base/clock.ts";
import { WORKS } from "../document/documents.ts";
import { recordStep } from "../document/steps.ts";
import { isProgram, textsOf, type Work } from "../document/work.ts";
import { isTaken, keepWork, readWork } from "./device.ts";
import { dropWork, keepState, newestState, refreshWorks } from "./keep.ts";
import { claimWork, owns, releaseWork, announceChange } from "./tab.ts";

/** Owner of the undo steps that change the list of works. */
const OF_WORKS = {};

/** A work as stored on the device. */
interface StoredWork {
  readonly work: string;
  readonly job: Work;
  readonly savedAt: number;
}

/** Runs while this tab holds the lock of a work; false if another tab has it. */
async function withWork(work: string, run: () => Promise<void>): Promise<boolean> {
  const had = owns(work);
  if (!(await claimWork(work))) return false;
  await run();
  if (!had) releaseWork(work);
  return true;
}

async function refreshAfter(change: Promise<unknown>): Promise<void> {
  await change;
  await refreshWorks();
  announceChange();
}

/** An entry of the list as the words of a step need it. */
interface ListedWork {
  readonly id: string;
  readonly name: string;
}
const listed = (works: readonly StoredWork[]): readonly ListedWork[] =>
  works.map(({ work, job }) => ({ id: work, name: job.name }));

/** Adds a step of undo for a change of the list. */
function noteStep(
  states: readonly [before: readonly ListedWork[], after: readonly ListedWork[]],
  back: () => Promise<unknown>,
  forth: () => Promise<unknown>,
): void {
  const way = (change: () => Promise<unknown>) => () => {
    void refreshAfter(change());
    return true;
  };
  recordStep({ document: WORKS, of: OF_WORKS, back: way(back), forth: way(forth), states });
}

/** A work as it is now; null if there is none. */
async function storedNow(work: string): Promise<StoredWork | null> {
  const job = await newestState(work);
  return job && { work, job, savedAt: (await readWork(work))?.savedAt ?? time() };
}

/** One after the other: a storage that is asked ten thousand things at once does not answer in time. */
async function inTurn<T>(all: readonly T[], change: (each: T) => Promise<unknown>): Promise<void> {
  for (const each of all) await change(each);
}

/** Works that are on the device at times: they are restored as they were when they were last removed. */
function comingAndGoing(works: readonly StoredWork[]) {
  const states = new Map(works.map((each) => [each.work, each]));
  return {
    /** Removes those that are not open in another tab. */
    remove: () =>
      inTurn([...states.keys()], (work) =>
        withWork(work, async () => {
          const now = await storedNow(work);
          if (now) states.set(work, now);
          await dropWork(work);
        }),
      ),
    /** Restores them, beside what has their names by now. If that fails they stay in memory, with a notice. */
    restore: () =>
      inTurn([...states.values()], async ({ work: own, job, savedAt }) => {
        const work = (await isTaken(own)) ? randomId() : own;
        if ((await keepWork(work, job, savedAt)) !== "kept") await keepState(work, job);
      }),
  };
}

/** What became of works that were to be deleted: those gone, and how many are open in other tabs, or still stored. */
export interface Removed {
  readonly gone: readonly StoredWork[];
  readonly leftOut: number;
  readonly refused: number;
}

/** Deletes works as one step of undo, except those open in other tabs. */
export async function removeWorks(works: readonly string[]): Promise<Removed> {
  const gone: StoredWork[] = [];
  let [leftOut, refused] = [0, 0];
  await inTurn(works, async (work) => {
    const free = await withWork(work, async () => {
      const one = await storedNow(work);
      if (one ? !(await dropWork(work)) : await isTaken(work)) refused += 1;
      else if (one) gone.push(one);
    });
    if (!free) leftOut += 1;
  });
  await refreshAfter(Promise.resolve());
  if (gone.length > 0) {
    const { remove, restore } = comingAndGoing(gone);
    noteStep([listed(gone), []], restore, remove);
  }
  return { gone, leftOut, refused };
}

/** Result of changing one work. */
export type WorkChange = "done" | "elsewhere" | "nameTaken" | "failed";

async function writeWork(work: string, job: Work, savedAt: number): Promise<WorkChange> {
  let done: WorkChange = "elsewhere";
  await withWork(work, async () => {
    done = (await keepWork(work, job, savedAt)) === "kept" ? "done" : "failed";
  });
  return done;
}

async function setName(work: string, name: string): Promise<WorkChange> {
  const now = await storedNow(work);
  return now ? writeWork(work, { ...now.job, name }, now.savedAt) : "failed";
}

/** Renames a work as one step of undo. Its date stays the same. */
export async function renameWork(work: string, name: string): Promise<WorkChange> {
  const now = await storedNow(work);
  if (!now) return "failed";
  const { job } = now;
  if (job.name === name) return "done";
  if (
    isProgram(job) &&
    textsOf(job)
      .slice(1)
      .some((file) => fileKey(file.name) === fileKey(name))
  )
    return "nameTaken";
  const done = await setName(work, name);
  await refreshAfter(Promise.resolve());
  if (done !== "done") return done;
  noteStep(
    [[{ id: work, name: job.name }], [{ id: work, name }]],
    () => setName(work, job.name),
    () => setName(work, name),
  );
  return done;
}

/** The longest name that a work is given here. */
const LONGEST = 32;

/** A free name: `A.h` becomes `A_2.h`. */
export function freeName(name: string, taken: readonly string[]): string {
  const known = new Set(taken.map(fileKey));
  const [, whole = "", ending = ""] = /^(.*?)(\.[^.]{0,8})?$/s.exec(name) ?? [];
  const stem = whole.replace(/_\d{1,4}$/, "");
  for (let n = 2; ; n++) {
    const made = `${stem.slice(0, LONGEST - `_${n}${ending}`.length)}_${n}${ending}`;
    if (!known.has(fileKey(made))) return made;
  }
}

/** Duplicates a work under a free name, as one step of undo; null if it cannot be saved. */
export async function duplicateWork(work: string, names: readonly string[]): Promise<StoredWork | null> {
  const job = await newestState(work);
  if (!job) return null;
  const copy: StoredWork = { work: randomId(), job: { ...job, name: freeName(job.name, names) }, savedAt: time() };
  const done = await writeWork(copy.work, copy.job, copy.savedAt);
  await refreshAfter(Promise.resolve());
  if (done !== "done") return null;
  const { remove, restore } = comingAndGoing([copy]);
  noteStep([[], listed([copy])], remove, restore);
  return copy;
}

/** Adds the works of a backup as one step of undo; returns how many could be saved. */
export async function addWorks(works: readonly StoredWork[]): Promise<number> {
  const kept: StoredWork[] = [];
  for (const each of works) if ((await writeWork(each.work, each.job, each.savedAt)) === "done") kept.push(each);
  await refreshAfter(Promise.resolve());
  if (kept.length > 0) {
    const { remove, restore } = comingAndGoing(kept);
    noteStep([[], listed(kept)], remove, restore);
  }
  return kept.length;
}
