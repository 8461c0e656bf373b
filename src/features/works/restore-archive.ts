import { time } from "../../app/base/clock.ts";
import { randomId } from "../../app/base/random-id.ts";
import { asOneStep, useSteps } from "../../app/document/steps.ts";
import type { ArchivedWork, ReadArchive } from "../../app/records/archive.ts";
import { isTaken, readWork } from "../../app/records/device.ts";
import { UNDATED } from "../../app/records/save-file.ts";
import { fingerprint } from "../../app/records/difference.ts";
import { useSavedWorks } from "../../app/records/keep.ts";
import { BOXES, PART_NAMES, PARTS, TABLES, type Group, type Part } from "../../app/records/parts.ts";
import { addWorks } from "../../app/records/works.ts";

/** State of a work in a backup: new, already here, or another one of the same name is here. */
export type ArchivedState = "fresh" | "same" | "beside";

/** The state of each work of an archive on this device. */
export async function statesOf(works: readonly ArchivedWork[]): Promise<readonly ArchivedState[]> {
  const here = new Map<string, string[]>();
  for (const { work, name } of useSavedWorks.getState().works) here.set(name, [...(here.get(name) ?? []), work]);
  const printOf = async (work: string) => {
    const kept = await readWork(work);
    return kept && fingerprint(kept.job);
  };
  const prints = new Map<string, Promise<readonly (string | null)[]>>();
  const printsOf = (name: string) => {
    const made = prints.get(name) ?? Promise.all((here.get(name) ?? []).map(printOf));
    prints.set(name, made);
    return made;
  };
  return Promise.all(
    works.map(async ({ job }) => {
      const known = await printsOf(job.name);
      if (known.includes(fingerprint(job))) return "same";
      return known.length > 0 ? "beside" : "fresh";
    }),
  );
}

/** What happens to a group of parts: mine stays, gets the missing entries, or is replaced. */
export type GroupChoice = "keep" | "missing" | "replace";
export type GroupChoices = Readonly<Record<Group, GroupChoice>>;

/** The default choices. */
export const DEFAULT_CHOICES: GroupChoices = {
  ...Object.fromEntries(Object.entries(BOXES).map(([group, ticked]) => [group, ticked ? "missing" : "keep"])),
  ...Object.fromEntries(TABLES.map((group) => [group, "keep"])),
} as GroupChoices;

const NO_NAMES: ReadonlyMap<string, string> = new Map();

/** The parts of a group that an archive brings. */
const archivedParts = (archive: ReadArchive, group: Group): readonly (readonly [Part<unknown>, unknown])[] =>
  PART_NAMES.flatMap((name) => {
    const part = PARTS[name],
      brought = archive[name];
    return part.group !== group || brought === null || part.isEmpty(brought) ? [] : [[part, brought] as const];
  });

/** The rows of a table in an archive, and the number that this device lacks; null if both tables are the same. */
export interface TableOffer {
  readonly rows: number;
  readonly missing: number | null;
}

const rowsOf = (table: unknown): number => (table as readonly unknown[]).length;

/** Null where the archive has no such table. */
export function tableOffer(archive: ReadArchive, table: (typeof TABLES)[number]): TableOffer | null {
  const [only] = archivedParts(archive, table);
  if (!only) return null;
  const [part, brought] = only,
    mine = part.current();
  const missing = part.isSame(brought, mine) ? null : rowsOf(part.merge(mine, brought, NO_NAMES)) - rowsOf(mine);
  return { rows: rowsOf(brought), missing };
}

/**
 * Whether an archive has anything of a group that this device lacks; null if it has nothing of the group. A group not
 * ticked by default is always offered.
 */
export function boxOffer(archive: ReadArchive, box: keyof typeof BOXES): boolean | null {
  const brought = archivedParts(archive, box);
  if (brought.length === 0) return null;
  return (
    !BOXES[box] ||
    brought.some(([part, value]) => {
      const mine = part.current();
      return !part.isSame(part.merge(mine, value, NO_NAMES), mine);
    })
  );
}

/** The result of a restore: works stored, works without room, and whether undo removes the other restored parts. */
interface RestoreResult {
  readonly kept: number;
  readonly full: number;
  readonly undone: boolean;
}

/** Restores the choices, each group as one step; never overwrites a work on the device. */
export async function restoreArchive(
  archive: ReadArchive,
  works: readonly ArchivedWork[],
  choices: GroupChoices,
): Promise<RestoreResult> {
  const here = new Set(useSavedWorks.getState().works.map(({ work }) => work));
  const lying: ArchivedWork[] = [];
  for (const each of works) {
    // A work that this edition cannot read is in no list, and is not written over either.
    const free = each.work !== "" && !here.has(each.work) && !(await isTaken(each.work));
    const work = free ? each.work : randomId();
    here.add(work);
    // A date in the future would keep the work at the head of the list.
    const savedAt = each.savedAt === UNDATED ? time() : Math.min(each.savedAt, time());
    lying.push({ ...each, work, savedAt });
  }
  const kept = await addWorks(lying);
  const nameHere = new Map(works.map(({ work }, i) => [work, lying[i]?.work ?? work]));
  const { newest } = useSteps.getState();
  for (const [group, choice] of Object.entries(choices) as [Group, GroupChoice][]) {
    if (choice === "keep") continue;
    const taken = asOneStep(() =>
      archivedParts(archive, group).map(([part, brought]) =>
        part.apply(choice === "replace" ? brought : part.merge(part.current(), brought, nameHere)),
      ),
    );
    await Promise.all(taken);
  }
  return { kept, full: lying.length - kept, undone: useSteps.getState().newest !== newest };
}
