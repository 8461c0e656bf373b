import { fileKey } from "../../program/state/program-files.ts";
import { randomId } from "../base/random-id.ts";
import { time } from "../base/clock.ts";
import { recordStep } from "../document/steps.ts";
import { isProgram, textsOf, type Work } from "../document/work.ts";
import { forgetWork, keepWork, readWork } from "./device.ts";
import { forgetUnsaved, keepState, newestState, refreshWorks } from "./keep.ts";
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

/** Adds a step of undo for a change of the list. */
function noteStep(back: () => Promise<unknown>, forth: () => Promise<unknown>): void {
  const way = (change: () => Promise<unknown>) => () => {
    void refreshAfter(change());
    return true;
  };
  recordStep({ of: OF_WORKS, back: way(back), forth: way(forth) });
}

const forgetAll = (gone: readonly StoredWork[]): Promise<unknown> =>
  Promise.all(
    gone.map(({ work }) => {
      forgetUnsaved(work);
      return forgetWork(work);
    }),
  );

/** Restores works. If that fails they stay in memory, with a notice. */
const restoreAll = (gone: readonly StoredWork[]): Promise<unknown> =>
  Promise.all(
    gone.map(async ({ work, job, savedAt }) => {
      if ((await keepWork(work, job, savedAt)) !== "kept") await keepState(work, job);
    }),
  );

/** Deletes works as one step of undo, except those open in other tabs. */
export async function removeWorks(
  works: readonly string[],
): Promise<{ readonly gone: readonly StoredWork[]; readonly leftOut: number }> {
  const gone: StoredWork[] = [];
  const done = await Promise.all(
    works.map((work) =>
      withWork(work, async () => {
        const job = await newestState(work);
        if (!job) return;
        const one = { work, job, savedAt: (await readWork(work))?.savedAt ?? time() };
        gone.push(one);
        await forgetAll([one]);
      }),
    ),
  );
  const leftOut = done.filter((free) => !free).length;
  await refreshAfter(Promise.resolve());
  if (gone.length > 0)
    noteStep(
      () => restoreAll(gone),
      () => forgetAll(gone),
    );
  return { gone, leftOut };
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

/** Renames a work as one step of undo. Its date stays the same. */
export async function renameWork(work: string, name: string): Promise<WorkChange> {
  const kept = await readWork(work);
  if (!kept) return "failed";
  const { job, savedAt } = kept;
  if (job.name === name) return "done";
  if (
    isProgram(job) &&
    textsOf(job)
      .slice(1)
      .some((file) => fileKey(file.name) === fileKey(name))
  )
    return "nameTaken";
  const renamed = { ...job, name };
  const done = await writeWork(work, renamed, savedAt);
  await refreshAfter(Promise.resolve());
  if (done !== "done") return done;
  noteStep(
    () => writeWork(work, job, savedAt),
    () => writeWork(work, renamed, savedAt),
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
  noteStep(
    () => forgetAll([copy]),
    () => restoreAll([copy]),
  );
  return copy;
}

/** Adds the works of a backup as one step of undo; returns how many could be saved. */
export async function addWorks(works: readonly StoredWork[]): Promise<number> {
  const kept: StoredWork[] = [];
  for (const each of works) if ((await writeWork(each.work, each.job, each.savedAt)) === "done") kept.push(each);
  await refreshAfter(Promise.resolve());
  if (kept.length > 0)
    noteStep(
      () => forgetAll(kept),
      () => restoreAll(kept),
    );
  return kept.length;
}
