import { decodeAny } from "../../document/encoding.ts";
import { LARGEST_PROGRAM } from "../../base/limits.ts";
import { shownFile } from "../../document/shown-file.ts";
import { asProgram } from "../../document/printed.ts";
import { openedVersion, bundleOf, flushEdits, openContent, useEditor, withBundle } from "../../document/store.ts";
import { fileKey } from "../../../program/state/program-files.ts";
import { onlyBundle, filesOf, withText, type ProgramWork } from "../../document/work.ts";

/** The open work in its current state; null if none is open. */
export function presentProgram(): ProgramWork | null {
  flushEdits();
  const open = openContent();
  return open && asProgram(open);
}

/** The other program and its name. A null name means the open work as it was opened. */
export interface ComparedProgram {
  readonly name: string | null;
  readonly program: ProgramWork;
}

/** The open work as it was opened, with its present tools and control; null if not known. */
export function openedProgram(): ProgramWork | null {
  const { work } = useEditor.getState();
  const opened = work === null ? null : openedVersion(work);
  return opened && asProgram(withBundle(opened, onlyBundle(bundleOf(useEditor.getState()))));
}

/** The open work as it was opened, if it has changed since. */
export function changedSinceOpened(present: ProgramWork): ComparedProgram | null {
  const program = openedProgram();
  return program && (program.text !== present.text || filesOf(program) !== filesOf(present))
    ? { name: null, program }
    : null;
}

/** The open work with another text for the shown file. */
export function withOtherText(present: ProgramWork, text: string): ProgramWork {
  const { program } = useEditor.getState();
  return withText(present, fileKey(program ? shownFile(program).name : present.name), text);
}

/** Text of a file on the device; null if it is no text. */
export async function textOfFile(file: File): Promise<string | null> {
  if (file.size > LARGEST_PROGRAM) return null;
  try {
    return decodeAny(new Uint8Array(await file.arrayBuffer())).text;
  } catch {
    return null;
  }
}
