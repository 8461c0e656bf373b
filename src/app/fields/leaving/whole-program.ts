import { presentFindings } from "../../findings/use-findings.ts";
import { copyJob, copyProgram } from "./copy-program.ts";
import { useEditor } from "../../document/store.ts";

/** True when a piece of text is a whole program: to take it along is to copy the program, however it is done. */
const isWholeProgram = (text: string): boolean =>
  (/BEGIN PGM/.test(text) && /END PGM/.test(text)) || (/^%\S+ G7[01]/m.test(text) && /^N99999999 %/m.test(text));

/**
 * Ctrl+C and the like on text that holds the whole program: with faults in it the browser's own copying is held back,
 * and the question comes first. What is shown as in the manual goes as the file. True when it was held back.
 */
export function guardCopy(event: ClipboardEvent, marked: string): boolean {
  const { faults, open } = presentFindings().verdict;
  const { job, program } = useEditor.getState();
  if ((faults === 0 && open === 0 && job?.layout !== "manual") || !isWholeProgram(marked)) return false;
  event.preventDefault();
  void (job ? copyJob(job) : copyProgram(program?.text ?? "", marked));
  return true;
}
