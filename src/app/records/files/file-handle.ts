import { DRAWING_ENDINGS } from "../../../program/drawing/endings.ts";

/** A file that the browser lets the page write back to. */
export interface FileHandle {
  readonly name: string;
  getFile(): Promise<File>;
  createWritable(): Promise<{ write(data: BufferSource): Promise<void>; close(): Promise<void> }>;
  queryPermission?(of: { readonly mode: "readwrite" }): Promise<PermissionState>;
  requestPermission?(of: { readonly mode: "readwrite" }): Promise<PermissionState>;
}

/** A folder that the browser lets the page look into. */
export interface FolderHandle {
  readonly kind: "directory";
  readonly name: string;
  values(): AsyncIterable<FolderHandle | (FileHandle & { readonly kind: "file" })>;
}

/** What browsers with access to files add to the page. */
interface FilePickers {
  readonly showOpenFilePicker?: (options: object) => Promise<readonly FileHandle[]>;
  readonly showDirectoryPicker?: () => Promise<FolderHandle>;
  readonly showSaveFilePicker?: (options: object) => Promise<FileHandle>;
}

const pickers = (): FilePickers => window as FilePickers;
/** Extensions of programs, point files and tables. */
export const ENDINGS: readonly string[] = [".h", ".H", ".i", ".I", ".hc", ".hu", ".d", ".tab", ".pnt", ".txt"];
const types = [{ description: "Klartext", accept: { "text/plain": ENDINGS } }];
/** Backups, tasks, results and drawings: opened here, saved elsewhere. */
const works = {
  description: "Turnwise",
  accept: { "application/zip": [".zip"], "application/json": [".json"], "application/octet-stream": DRAWING_ENDINGS },
};

export const canOpenFiles = (): boolean => typeof pickers().showOpenFilePicker === "function";
export const canSaveFiles = (): boolean => typeof pickers().showSaveFilePicker === "function";

/** A chosen file, with write access if the browser grants it. */
export interface Chosen {
  readonly file: File;
  readonly handle: FileHandle | null;
}

/** Files without write access. */
export const plainFiles = (files: FileList | readonly File[] | null): readonly Chosen[] =>
  Array.from(files ?? [], (file) => ({ file, handle: null }));

/** Asks for files; none when the operator closes the question. */
export async function pickFiles(): Promise<readonly Chosen[]> {
  try {
    const picked =
      (await pickers().showOpenFilePicker?.({
        types: [...types, works],
        excludeAcceptAllOption: false,
        multiple: true,
      })) ?? [];
    return await Promise.all(picked.map(async (handle) => ({ file: await handle.getFile(), handle })));
  } catch {
    return [];
  }
}

/** Extensions and types of all that opens as a work or is restored. */
export const OPENED: readonly string[] = [...ENDINGS, "text/plain", ".zip", ".json", ...DRAWING_ENDINGS];

/** Asks for files in whichever way the browser has. `accept`: their extensions and types. */
export function askForFiles(accept: readonly string[] = [...ENDINGS, "text/plain"]): Promise<readonly Chosen[]> {
  if (canOpenFiles()) return pickFiles();
  return new Promise((resolve) => {
    const input = document.createElement("input");
    input.type = "file";
    input.multiple = true;
    input.accept = accept.join(",");
    input.addEventListener("change", () => resolve(plainFiles(input.files)));
    input.addEventListener("cancel", () => resolve([]));
    input.click();
  });
}

/** The file or folder behind something that was dropped; null where the browser gives no access to it. */
export async function handleOf(item: DataTransferItem): Promise<FileHandle | FolderHandle | null> {
  try {
    const get = (item as { getAsFileSystemHandle?: () => Promise<FileHandle | FolderHandle | null> })
      .getAsFileSystemHandle;
    return get ? await get.call(item) : null;
  } catch {
    return null;
  }
}

/** Asks where a file is to be saved; null when the operator closes the question. */
export async function askWhere(name: string): Promise<FileHandle | null> {
  try {
    return (await pickers().showSaveFilePicker?.({ suggestedName: name, types })) ?? null;
  } catch {
    return null;
  }
}

/**
 * Asks for a folder; null when the operator closes the question, undefined where the browser can not ask for it in this
 * way.
 */
export async function pickFolder(): Promise<FolderHandle | null | undefined> {
  const pick = pickers().showDirectoryPicker;
  if (!pick) return undefined;
  try {
    return await pick.call(window);
  } catch {
    return null;
  }
}
