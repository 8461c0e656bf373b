import { notice } from "../../saving/keep.ts";
import { LARGEST_TAUGHT, readTaught, readTaughtLink, type ReadTaught } from "./taught-files.ts";
import { showTaught } from "./taught-shown.ts";

const PROBLEMS = { tooLarge: "linkTooLarge", newer: "linkNewer", damaged: "linkDamaged" } as const;

/** Shows what was read; true where something was. */
function shown(read: ReadTaught): boolean {
  if (read.kind !== "task" && read.kind !== "result") return false;
  showTaught(read);
  return true;
}

/** Shows the task or the results of a link, or says why it carries none. */
export function openTaughtLink(hash: string): void {
  const read = readTaughtLink(hash);
  if (!shown(read)) notice(PROBLEMS[read.kind as keyof typeof PROBLEMS]);
}

/** Shows the task or the results of a file. */
export async function openTaughtFile(file: File): Promise<"opened" | "tooLarge" | "unreadable"> {
  if (file.size > LARGEST_TAUGHT) return "tooLarge";
  try {
    const read = readTaught(await file.text());
    return shown(read) ? "opened" : read.kind === "tooLarge" ? "tooLarge" : "unreadable";
  } catch {
    return "unreadable";
  }
}
