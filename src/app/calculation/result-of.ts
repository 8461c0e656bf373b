import { printedText } from "../document/printed.ts";
import { isProgram, type Work } from "../document/work.ts";
import { isMadeFrom, type Outcome } from "./outcome.ts";

/** Whether a result belongs to a work in its present state. Apart from the results: it needs the printer of jobs. */
export const isResultOf = (outcome: Outcome, work: Work): boolean =>
  isProgram(work) ? isMadeFrom(outcome, work) : outcome.text === printedText(work);
