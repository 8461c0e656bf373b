import { decode } from "../editor/encoding.ts";
import { startWork } from "../saving/keep.ts";
import { useEditor } from "../store.ts";
import type { ProgramWork } from "../work.ts";
import { handleOf, rememberHandle, type FileHandle } from "./file-handle.ts";

/** Files larger than this are no programs, bytes. */
const LARGEST = 50_000_000;

/** Opens a program as work of its own; what was open stays on the device. */
export function openProgram(program: ProgramWork, handle: FileHandle | null = null): void {
  startWork(program);
  const { work } = useEditor.getState();
  if (work !== null && handle) rememberHandle(work, handle);
}

/** Opens a file of the device; false when it can not be read. */
export async function openFile(file: File, handle: FileHandle | null = null): Promise<boolean> {
  try {
    if (file.size > LARGEST) return false;
    openProgram({ name: file.name, ...decode(new Uint8Array(await file.arrayBuffer())) }, handle);
    return true;
  } catch {
    return false;
  }
}

/** The name of a program's file, from its first block. */
export const fileNameOf = (text: string): string => `${/BEGIN PGM (\S+)/.exec(text)?.[1]?.replace(/[\\/:*?"<>|]/g, "_") ?? "PROGRAM"}.h`;

/** Opens text that was pasted, shared or printed. */
export const openText = (text: string): void => openProgram({ name: fileNameOf(text), text, encoding: "utf-8" });

/** Opens what was dropped on the page, with the right to write it back where the browser gives it; false when nothing can be read. */
export async function openDropped(data: DataTransfer): Promise<boolean> {
  const [file] = data.files;
  const item = [...data.items].find((each) => each.kind === "file");
  if (file) {
    const handle = item ? handleOf(item) : Promise.resolve(null);
    return openFile(file, await handle);
  }
  const text = data.getData("text/plain");
  if (text.trim() === "") return false;
  openText(text);
  return true;
}
