import { fileKey } from "../../program/state/program-files.ts";
import { drawnId } from "../base/chance.ts";
import { time } from "../base/clock.ts";
import { note } from "../document/steps.ts";
import { isProgram, textsOf, type Work } from "../document/work.ts";
import { forgetWork, keepWork, readWork } from "./device.ts";
import { forgetUnkept, keepState, newestState, refreshWorks } from "./keep.ts";
import { claimWork, owns, releaseWork, sayChanged } from "./tab.ts";

/** Owner of the undo steps that change the list of works. */
const OF_WORKS = {};

/** A work as stored on the device. */
interface Lying {
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

async function shown(change: Promise<unknown>): Promise<void> {
  await change;
  await refreshWorks();
  sayChanged();
}

/** Adds a step of undo for a change of the list. */
function noteStep(back: () => Promise<unknown>, forth: () => Promise<unknown>): void {
  const way = (change: () => Promise<unknown>) => () => {
    void shown(change());
    return true;
  };
  note({ of: OF_WORKS, back: way(back), forth: way(forth) });
}

const forgetAll = (gone: readonly Lying[]): Promise<unknown> =>
  Promise.all(
    gone.map(({ work }) => {
      forgetUnkept(work);
      return forgetWork(work);
    }),
  );

/** Restores works. If that fails they stay in memory, with a notice. */
const putBackAll = (gone: readonly Lying[]): Promise<unknown> =>
  Promise.all(
    gone.map(async ({ work, job, savedAt }) => {
      if ((await keepWork(work, job, savedAt)) !== "kept") await keepState(work, job);
    }),
  );

/** Deletes works as one step of undo, except those open in other tabs. */
export async function removeWorks(
  works: readonly string[],
): Promise<{ readonly gone: readonly Lying[]; readonly leftOut: number }> {
  const gone: Lying[] = [];
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
  await shown(Promise.resolve());
  if (gone.length > 0)
    noteStep(
      () => putBackAll(gone),
      () => forgetAll(gone),
    );
  return { gone, leftOut };
}

/** Result of changing one work. */
export type WorkChange = "done" | "elsewhere" | "nameTaken" | "failed";

async function put(work: string, job: Work, savedAt: number): Promise<WorkChange> {
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
  const done = await put(work, renamed, savedAt);
  await shown(Promise.resolve());
  if (done !== "done") return done;
  noteStep(
    () => put(work, job, savedAt),
    () => put(work, renamed, savedAt),
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
export async function duplicateWork(work: string, names: readonly string[]): Promise<Lying | null> {
  const job = await newestState(work);
  if (!job) return null;
  const copy: Lying = { work: drawnId(), job: { ...job, name: freeName(job.name, names) }, savedAt: time() };
  const done = await put(copy.work, copy.job, copy.savedAt);
  await shown(Promise.resolve());
  if (done !== "done") return null;
  noteStep(
    () => forgetAll([copy]),
    () => putBackAll([copy]),
  );
  return copy;
}

/** Adds the works of a backup as one step of undo; returns how many could be saved. */
export async function addWorks(works: readonly Lying[]): Promise<number> {
  const kept: Lying[] = [];
  for (const each of works) if ((await put(each.work, each.job, each.savedAt)) === "done") kept.push(each);
  await shown(Promise.resolve());
  if (kept.length > 0)
    noteStep(
      () => forgetAll(kept),
      () => putBackAll(kept),
    );
  return kept.length;
}
