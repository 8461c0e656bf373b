import { time } from "../../app/base/clock.ts";
import { dayText } from "../../app/base/clock-text.ts";
import { downloadBytes } from "../../app/base/download.ts";
import { ARCHIVE_LIMITS, writeArchive, type ArchivedWork } from "../../app/records/archive.ts";
import { findWorks, readWork } from "../../app/records/device.ts";
import { newestState, useSavedWorks } from "../../app/records/keep.ts";
import { eachPart } from "../../app/records/parts.ts";
import { flushEdits } from "../../app/document/store.ts";

/** Size limit of one file, bytes, so that it can be restored: an archive has each program twice. */
const LARGEST = ARCHIVE_LIMITS.unpacked / 4;

async function storedWork(work: string): Promise<ArchivedWork | null> {
  const job = await newestState(work);
  return job && { work, job, savedAt: (await readWork(work))?.savedAt ?? time() };
}

/** Divides the works among as many files as are needed. */
function splitIntoFiles(works: readonly string[], sizes: ReadonlyMap<string, number>): readonly (readonly string[])[] {
  const files: string[][] = [[]];
  let held = 0;
  for (const work of works) {
    const size = sizes.get(work) ?? 0;
    if (held > 0 && held + size > LARGEST) {
      files.push([]);
      held = 0;
    }
    files.at(-1)?.push(work);
    held += size;
  }
  return files;
}

/** Name of a backup file, with the day. */
function fileName(part: number, of: number): string {
  const day = dayText(new Date(time()));
  return `turnwise-${day}${of > 1 ? `-${part}-${of}` : ""}.zip`;
}

async function save(
  works: readonly string[],
  beside: Parameters<typeof writeArchive>[0],
): Promise<{ readonly works: number; readonly files: number }> {
  const sizes = new Map(useSavedWorks.getState().works.map(({ work, size }) => [work, size]));
  const files = splitIntoFiles(works, sizes);
  let count = 0;
  for (const [i, each] of files.entries()) {
    const found: ArchivedWork[] = [];
    for (const work of each) {
      const one = await storedWork(work);
      if (one) found.push(one);
    }
    count += found.length;
    downloadBytes(writeArchive({ ...(i === 0 && beside), works: found }), fileName(i + 1, files.length));
  }
  return { works: count, files: files.length };
}

/** Downloads some works as a file to restore them from; returns their number. */
export async function saveWorks(works: readonly string[]): Promise<number> {
  flushEdits();
  return (await save(works, {})).works;
}

/**
 * Downloads a backup of this device: works, and all other parts of an archive. Includes works that could not be stored.
 */
export async function saveBackup(
  unkept: readonly string[],
): Promise<{ readonly works: number; readonly files: number }> {
  flushEdits();
  const { works } = await findWorks();
  const all = [...new Set([...works.map(({ work }) => work), ...unkept])];
  return save(
    all,
    eachPart((part) => part.current()),
  );
}
