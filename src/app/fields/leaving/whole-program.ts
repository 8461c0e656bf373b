import { presentFindings } from "../../findings/use-findings.ts";
import { copyJob, copyProgram } from "./copy-program.ts";
import { useEditor } from "../../document/store.ts";

/** True if a text is a whole program, so that copying it exports the program. */
const isWholeProgram = (text: string): boolean =>
  (/BEGIN PGM/.test(text) && /END PGM/.test(text)) || (/^%\S+ G7[01]/m.test(text) && /^N99999999 %/m.test(text));

/**
 * Handles copying a selection that holds the whole program: with faults the browser's copy is stopped and the question
 * comes first. A program shown as in the manual is copied as its file. Returns true if stopped.
 */
export function guardCopy(event: ClipboardEvent, marked: string): boolean {
  const { faults, open } = presentFindings().verdict;
  const { job } = useEditor.getState();
  if ((faults === 0 && open === 0 && job?.layout !== "manual") || !isWholeProgram(marked)) return false;
  event.preventDefault();
  void (job ? copyJob(job) : copyProgram(marked));
  return true;
}
