import { presentFindings } from "../findings/use-findings.ts";
import { printedText } from "../printed.ts";
import { copyProgram } from "./copy-program.ts";
import { useEditor } from "../store.ts";

/** True when a piece of text is a whole program: to take it along is to copy the program, however it is done. */
const isWholeProgram = (text: string): boolean => /BEGIN PGM/.test(text) && /END PGM/.test(text);

/**
 * Ctrl+C and the like on text that holds the whole program: with faults in it the browser's own copying is held back, and
 * the question comes first. True when it was held back.
 */
export function guardCopy(event: ClipboardEvent, marked: string): boolean {
  const { faults, open } = presentFindings().verdict;
  if ((faults === 0 && open === 0) || !isWholeProgram(marked)) return false;
  const { job, program } = useEditor.getState();
  event.preventDefault();
  void copyProgram(job ? printedText(job) : (program?.text ?? ""), marked);
  return true;
}
