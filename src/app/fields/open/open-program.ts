import type { HandedOn } from "../../../program/job/job.ts";
import { retryImport } from "../../base/parts.ts";
import { startWork } from "../../records/keep.ts";
import { onlyBundle, type ProgramWork, type WorkFile } from "../../document/work.ts";
import { fileNameOf } from "../../base/file-name.ts";
import { asKlartext, mayBeIso } from "../../records/files/iso-file.ts";
import { handleOf } from "../../records/files/file-handle.ts";

/** Opens a program as a new work; the previous one stays saved. */
export const openProgram = (program: ProgramWork): void => void startWork(program);

/** The part that opens files is fetched when there are some. */
export const fetchOpenFiles = () => retryImport(() => import("./open-files.ts"));

/** Opens pasted or printed text, with the tools, settings and output format of the work it was printed from. */
export function openText(text: string, { output, ...brought }: HandedOn & Pick<ProgramWork, "output"> = {}): void {
  const file = { name: fileNameOf(text), text, encoding: "utf-8" } as const;
  const open = (made: WorkFile) => openProgram({ ...made, ...onlyBundle(brought), ...(output && { output }) });
  if (mayBeIso(text)) void asKlartext(file).then(open);
  else open(file);
}

/** Opens a dropped text or dropped files, with write access where the browser grants it. A failure shows a notice. */
export async function openDropped(data: DataTransfer): Promise<void> {
  // Drop data can only be read synchronously.
  const items = [...data.items].filter((each) => each.kind === "file");
  const entries = items.map((each) => each.webkitGetAsEntry?.() ?? null);
  const handles = items.map(handleOf);
  const files = [...data.files];
  const text = data.getData("text/plain");
  if (items.length === 0 && files.length === 0) {
    if (text.trim() !== "") openText(text);
    return;
  }
  const [{ openDroppedFiles }, known] = await Promise.all([fetchOpenFiles(), Promise.all(handles)]);
  await openDroppedFiles(
    files,
    known.map((handle, i) => ({ handle, entry: entries[i] ?? null })),
  );
}
