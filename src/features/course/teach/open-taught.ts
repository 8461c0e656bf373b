import { LARGEST_TAUGHT, readTaught, readTaughtLink, isTaughtText, type ReadTaught } from "./taught-files.ts";
import { showProblem, showSet, showTask } from "../../../app/records/course/opened-course-file.ts";
import { showResults, type NamedResult } from "../../../app/records/course/show-results.ts";

/** Shows the task or the results of a link, or why it has none. */
export async function openTaughtLink(hash: string): Promise<void> {
  show("", await readTaughtLink(hash));
}

function show(file: string, read: ReadTaught): void {
  if (read.kind === "task") showTask(read.task, read.left);
  else if (read.kind === "set") showSet(read.set, read.left);
  else if (read.kind === "result") showResults([{ file, result: read.result }]);
  else showProblem(file, read);
}

async function readFile(file: File): Promise<ReadTaught> {
  if (file.size > LARGEST_TAUGHT) return { kind: "tooLarge" };
  try {
    return readTaught(await file.text());
  } catch {
    return { kind: "unreadable" };
  }
}

/** Adds results from files to those shown; files without results are named. */
export async function addResults(files: readonly File[]): Promise<void> {
  showResults(
    await Promise.all(
      files.map(async (file): Promise<NamedResult> => {
        const read = await readFile(file);
        if (read.kind === "result") return { file: file.name, result: read.result };
        return { file: file.name, why: read.kind === "task" || read.kind === "set" ? { kind: "task" } : read };
      }),
    ),
  );
}

const BEGINNING = 4096;

/** Whether one of several files contains a task or results, whatever its name. */
export async function areTaughtFiles(files: readonly File[]): Promise<boolean> {
  for (const file of files.filter(({ name }) => /\.(?:json|txt)$/i.test(name))) {
    try {
      // A file over the size limit is recognized by its beginning.
      if (isTaughtText(await (file.size > LARGEST_TAUGHT ? file.slice(0, BEGINNING) : file).text())) return true;
    } catch {
      return false;
    }
  }
  return false;
}

/** Shows the task of a file, or the results of one or several; files with neither are reported. */
export async function openTaughtFiles(files: readonly File[]): Promise<void> {
  const [first, ...others] = files;
  if (!first) return;
  if (others.length > 0) return addResults(files);
  show(first.name, await readFile(first));
}
