/** A file that the browser lets the page write back to. */
export interface FileHandle {
  readonly name: string;
  getFile(): Promise<File>;
  createWritable(): Promise<{ write(data: BufferSource): Promise<void>; close(): Promise<void> }>;
}

/** What browsers with access to files add to the page. */
interface FilePickers {
  readonly showOpenFilePicker?: (options: object) => Promise<readonly FileHandle[]>;
  readonly showSaveFilePicker?: (options: object) => Promise<FileHandle>;
}

const pickers = (): FilePickers => window as FilePickers;
const types = [{ description: "Klartext", accept: { "text/plain": [".h", ".H", ".i", ".txt"] } }];

/** Files of the works that were opened since the page was loaded. */
const handles = new Map<string, FileHandle>();

export const rememberHandle = (work: string, handle: FileHandle): void => void handles.set(work, handle);
export const knownHandle = (work: string | null): FileHandle | null => (work === null ? null : (handles.get(work) ?? null));

export const canOpenFiles = (): boolean => typeof pickers().showOpenFilePicker === "function";
export const canSaveFiles = (): boolean => typeof pickers().showSaveFilePicker === "function";

/** Asks for a file; null when the operator closes the question. */
export async function pickFile(): Promise<FileHandle | null> {
  try {
    return (await pickers().showOpenFilePicker?.({ types, excludeAcceptAllOption: false }))?.[0] ?? null;
  } catch {
    return null;
  }
}

/** The file behind something that was dropped; null where the browser gives no access to it. */
export async function handleOf(item: DataTransferItem): Promise<FileHandle | null> {
  try {
    const get = (item as { getAsFileSystemHandle?: () => Promise<FileHandle | null> }).getAsFileSystemHandle;
    return get ? await get.call(item) : null;
  } catch {
    return null;
  }
}

/** Writes to the file of a work, asking where when none is known; "closed" when the operator closes the question. */
export async function writeFile(work: string, name: string, bytes: BufferSource): Promise<"written" | "closed" | "failed"> {
  let handle = knownHandle(work);
  if (!handle) {
    try {
      handle = (await pickers().showSaveFilePicker?.({ suggestedName: name, types })) ?? null;
    } catch {
      return "closed";
    }
  }
  if (!handle) return "failed";
  try {
    const out = await handle.createWritable();
    await out.write(bytes);
    await out.close();
    rememberHandle(work, handle);
    return "written";
  } catch {
    return "failed";
  }
}
