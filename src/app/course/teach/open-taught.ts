import { notice } from "../../saving/keep.ts";
import { LARGEST_TAUGHT, readTaught, readTaughtLink, type ReadTaught } from "./taught-files.ts";
import { showResults, showTask, type NamedResult } from "./taught-shown.ts";

const PROBLEMS = { tooLarge: "linkTooLarge", newer: "linkNewer", damaged: "linkDamaged" } as const;

/** Shows the task or the results of a link, or says why it carries none. */
export function openTaughtLink(hash: string): void {
  const read = readTaughtLink(hash);
  if (read.kind === "task") showTask(read.task);
  else if (read.kind === "result") showResults([{ file: "", result: read.result }]);
  else notice(PROBLEMS[read.kind]);
}

async function readFile(file: File): Promise<ReadTaught> {
  if (file.size > LARGEST_TAUGHT) return { kind: "tooLarge" };
  try {
    return readTaught(await file.text());
  } catch {
    return { kind: "damaged" };
  }
}

/** Shows results out of files, beside those that are shown; what is none is named. */
export async function addResults(files: readonly File[]): Promise<void> {
  showResults(await Promise.all(files.map(async (file): Promise<NamedResult> => {
    const read = await readFile(file);
    return { file: file.name, result: read.kind === "result" ? read.result : null };
  })));
}

/** Shows the task of a file, or the results of one or several. */
export async function openTaughtFiles(files: readonly File[]): Promise<"opened" | "tooLarge" | "unreadable"> {
  const [first] = files, read = first && await readFile(first);
  if (!read) return "unreadable";
  if (read.kind === "task" && files.length === 1) {
    showTask(read.task);
    return "opened";
  }
  if (files.length === 1 && read.kind !== "result") {
    if (read.kind === "newer") notice("linkNewer");
    return read.kind === "newer" ? "opened" : read.kind === "tooLarge" ? "tooLarge" : "unreadable";
  }
  await addResults(files);
  return "opened";
}
