import { decodeAny } from "../../document/encoding.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import { kindOfName } from "../../../program/drawing/endings.ts";
import { fileKey } from "../../../program/state/program-files.ts";
import { retryImport } from "../../base/parts.ts";
import { courseFilesSlot } from "../slots.ts";
import { notice } from "../../base/notices.ts";
import { changeProgram, useEditor } from "../../document/store.ts";
import { startWork } from "../../records/keep.ts";
import { readBackup, isArchiveName } from "../../records/pending-restore.ts";
import { textsOf, withFile, type ProgramWork, type WorkFile } from "../../document/work.ts";
import { asKlartext } from "../../records/files/iso-file.ts";
import { openDrawing } from "../../document/drawing-request.ts";
import { askWhichPrograms, useProgramChoice } from "../../document/program-choice.ts";
import type { DroppedPart, FolderContent } from "../../records/files/folder.ts";
import { askForFiles, OPENED, plainFiles, type Chosen, type FileHandle } from "../../records/files/file-handle.ts";
import { LARGEST_PROGRAM } from "../../base/limits.ts";
import { missingFiles } from "../../calculation/missing-files.ts";

/** Result of opening files. */
export type OpenResult = "opened" | "tooLarge" | "unreadable";

interface Read {
  readonly files: readonly WorkFile[];
  readonly handles: readonly {
    readonly name: string;
    readonly handle: FileHandle;
    readonly bytes: Uint8Array<ArrayBuffer>;
  }[];
  /** False when one of them could not be read. */
  readonly whole: boolean;
}

/**
 * Reads chosen files; of two with the same name the first counts. A file translated from DIN/ISO is not written back.
 */
async function read(chosen: readonly Chosen[]): Promise<Read> {
  const all = await Promise.all(
    chosen.map(async ({ file, handle }) => {
      try {
        const bytes = new Uint8Array(await file.arrayBuffer());
        const own = { name: file.name, ...decodeAny(bytes) };
        const klartext = await asKlartext(own);
        return { file: klartext, handle: klartext === own ? handle : null, bytes };
      } catch {
        return null;
      }
    }),
  );
  const found = [
    ...new Map(all.flatMap((each) => (each ? [[fileKey(each.file.name), each] as const] : [])).reverse()).values(),
  ].reverse();
  return {
    files: found.map(({ file }) => file),
    handles: found.flatMap(({ file, handle, bytes }) => (handle ? [{ name: file.name, handle, bytes }] : [])),
    whole: all.every((each) => each !== null),
  };
}

/** Stores the file handles of the open work, so that it can be saved back. */
async function remember({ handles }: Pick<Read, "handles">): Promise<void> {
  const { work } = useEditor.getState();
  if (work === null || handles.length === 0) return;
  const { keepHandle } = await retryImport(() => import("../../records/files/kept-handles.ts"));
  for (const { name, handle, bytes } of handles) await keepHandle(work, name, handle, bytes);
}

/** Opens a read work with its file handles. */
async function openRead(work: ProgramWork, { handles }: Pick<Read, "handles">): Promise<void> {
  await startWork(work);
  const keys = new Set(textsOf(work).map(({ name }) => fileKey(name)));
  void remember({ handles: handles.filter(({ name }) => keys.has(fileKey(name))) });
}

/**
 * Opens files as one work if one program calls the others. If several could be the main program, it asks which; closing
 * the question opens none.
 */
async function openTogether(found: Read, { skipped, isCut }: Omit<FolderContent, "files">): Promise<boolean> {
  const { files } = found;
  const [first] = files;
  if (!first) return false;
  if (files.length === 1) {
    await openRead(first, found);
    return true;
  }
  const [{ mainOf }, { parse }] = await Promise.all([
    import("../../../program/run/main-program.ts"),
    import("../../../nc/parse.ts"),
  ]);
  const { index, sure, free } = mainOf(files, parse);
  const main = files[index] ?? first;
  const whole: ProgramWork = { ...main, files: files.filter((file) => file !== main) };
  const workOf = (at: number, calls: readonly number[]): ProgramWork => {
    const beside = calls.flatMap((i) => files[i] ?? []);
    const own = files[at] ?? first;
    return beside.length > 0 ? { ...own, files: beside } : own;
  };
  if (free.length < 2) {
    await openRead(whole, found);
    if (!sure) notice("mainUnsure");
    return true;
  }
  const openEach = async (works: readonly ProgramWork[]) => {
    for (const each of works) await openRead(each, found);
  };
  askWhichPrograms({
    works: free.map(({ index: at, calls }) => workOf(at, calls)),
    skipped,
    isCut,
    // The first one is opened last, so that it is the one shown.
    open: (works) => void openEach(works.toReversed()),
    together: () => void openRead(whole, found),
  });
  return true;
}

const sizeOf = (chosen: readonly Chosen[]): number => chosen.reduce((sum, { file }) => sum + file.size, 0);

/** Opens files as one work; on failure the previous work stays open. */
export async function openFiles(chosen: readonly Chosen[]): Promise<OpenResult> {
  const [first] = chosen;
  if (first && isArchiveName(first.file.name)) {
    await readBackup(first.file);
    return "opened";
  }
  const drawn = chosen.find(({ file }) => kindOfName(file.name) !== null);
  if (drawn) {
    openDrawing(drawn.file);
    return "opened";
  }
  if (chosen.some(({ file }) => /\.json$/i.test(file.name)) && (await openCourseFiles(chosen.map(({ file }) => file))))
    return "opened";
  return openProgramFiles(chosen, { skipped: 0, isCut: false });
}

/** Opens tasks and results, recognised by file name or content; false for other files. */
async function openCourseFiles(files: readonly File[]): Promise<boolean> {
  const { areTaughtFiles, openTaughtFiles } = await retryImport(courseFilesSlot.fetch);
  if (
    !files.some(({ name }) => /\.turnwise-(?:task|result)\b/i.test(name) && /\.json$/i.test(name)) &&
    !(await areTaughtFiles(files))
  )
    return false;
  await openTaughtFiles(files);
  return true;
}

async function openProgramFiles(chosen: readonly Chosen[], leftOut: Omit<FolderContent, "files">): Promise<OpenResult> {
  try {
    if (sizeOf(chosen) > LARGEST_PROGRAM) return "tooLarge";
    const found = await read(chosen);
    if (!(await openTogether(found, leftOut))) return "unreadable";
    if (!found.whole) notice("fileUnreadable");
    return "opened";
  } catch {
    return "unreadable";
  }
}

/** Opens the files of a folder, with a notice about skipped ones. */
export async function openFolder({ files, ...leftOut }: FolderContent): Promise<OpenResult> {
  const opening = await openProgramFiles(files, leftOut);
  if (opening === "opened" && (leftOut.skipped > 0 || leftOut.isCut) && !useProgramChoice.getState().choice)
    notice("filesLeftOut");
  return opening;
}

/** Adds files to the open program as one step of undo. `name`: the name by which a single file is called. */
export async function addFiles(chosen: readonly Chosen[], name: string | null = null): Promise<void> {
  const { program, work } = useEditor.getState();
  if (!program || chosen.length === 0) return;
  const held = textsOf(program).reduce((sum, { text }) => sum + text.length, 0);
  if (held + sizeOf(chosen) > LARGEST_PROGRAM) return notice("fileTooLarge");
  const found = await read(chosen);
  if (useEditor.getState().work !== work) return;
  const named = ([file]: readonly WorkFile[]) => (file && name !== null ? [{ ...file, name }] : []);
  const files = name !== null && found.files.length === 1 ? named(found.files) : found.files;
  changeProgram((now) => files.reduce(withFile, now));
  void remember(found);
  if (!found.whole) notice("fileUnreadable");
}

/** True if the open program is missing all of the dropped files. */
function areMissingFiles(chosen: readonly Chosen[]): boolean {
  const { program } = useEditor.getState();
  const missing = new Set(program ? missingFiles(program, useOutcome.getState().newest).map(fileKey) : []);
  return chosen.every(({ file }) => missing.has(fileKey(file.name)));
}

function sayNot(opening: OpenResult): void {
  if (opening !== "opened") notice(opening === "tooLarge" ? "fileTooLarge" : "fileUnreadable");
}

/** Asks for files and opens them. A failure shows a notice. */
export async function openAskedFiles(): Promise<void> {
  const chosen = await askForFiles(OPENED);
  if (chosen.length > 0) sayNot(await openFiles(chosen));
}

/** Opens dropped files and folders; a file has the part with its index. A failure shows a notice. */
export async function openDroppedFiles(files: readonly File[], parts: readonly DroppedPart[]): Promise<void> {
  if (parts.some(({ handle, entry }) => entry?.isDirectory || (handle && "values" in handle))) {
    const { filesOfDrop } = await retryImport(() => import("../../records/files/folder.ts"));
    return sayNot(await openFolder(await filesOfDrop(parts)));
  }
  const chosen = plainFiles(files).map((each, i): Chosen => {
    const handle = parts[i]?.handle ?? null;
    return { ...each, handle: handle && !("values" in handle) ? handle : null };
  });
  if (areMissingFiles(chosen)) return addFiles(chosen);
  return sayNot(await openFiles(chosen));
}
