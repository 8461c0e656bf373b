import { decode } from "../editor/encoding.ts";
import { notice, startWork } from "../saving/keep.ts";
import { useEditor } from "../store.ts";
import type { ProgramWork } from "../work.ts";
import { handleOf, rememberHandle, type FileHandle } from "./file-handle.ts";
import { LARGEST_PROGRAM } from "./limits.ts";

/** Opens a program as work of its own; what was open stays on the device. */
export function openProgram(program: ProgramWork, handle: FileHandle | null = null): void {
  startWork(program);
  const { work } = useEditor.getState();
  if (work !== null && handle) rememberHandle(work, handle);
}

/** What became of a file that was to be opened. */
export type Opening = "opened" | "tooLarge" | "unreadable";

/** Opens a file of the device. What was open before stays open when it can not. */
export async function openFile(file: File, handle: FileHandle | null = null): Promise<Opening> {
  try {
    if (file.size > LARGEST_PROGRAM) return "tooLarge";
    openProgram({ name: file.name, ...decode(new Uint8Array(await file.arrayBuffer())) }, handle);
    return "opened";
  } catch {
    return "unreadable";
  }
}

/** The name of a program's file, from its first block. */
export const fileNameOf = (text: string): string => `${/BEGIN PGM (\S+)/.exec(text)?.[1]?.replace(/[\\/:*?"<>|]/g, "_") ?? "PROGRAM"}.h`;

/** Opens text that was pasted, shared or printed. */
export const openText = (text: string): void => openProgram({ name: fileNameOf(text), text, encoding: "utf-8" });

/** Opens what was dropped on the page, with the right to write it back where the browser gives it. What can not be opened is said. */
export async function openDropped(data: DataTransfer): Promise<void> {
  const [file] = data.files;
  const item = [...data.items].find((each) => each.kind === "file");
  if (file) {
    const handle = item ? handleOf(item) : Promise.resolve(null);
    const opening = await openFile(file, await handle);
    if (opening !== "opened") notice(opening === "tooLarge" ? "fileTooLarge" : "fileUnreadable");
    return;
  }
  const text = data.getData("text/plain");
  if (text.trim() !== "") openText(text);
}
