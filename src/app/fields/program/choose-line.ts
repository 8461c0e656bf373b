import { askedByMove } from "../../../cycles/asked-by-move.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import { openPrompt, showPrompt, showSection, usePlace } from "../../place/place.ts";
import { printedText } from "../../document/printed.ts";
import type { JobReading } from "../../document/reading.ts";
import { NOTHING_SELECTED, useSelection } from "../../document/selected.ts";
import { chooseLine } from "../../pictures/selection.ts";
import type { ChosenLine } from "./ProgramText.tsx";

/**
 * A line of the program was pointed at: it is marked, its prompt opens, the tool goes to its block, and the path of
 * that is marked.
 */
export async function chooseJobLine(read: JobReading, line: ChosenLine): Promise<void> {
  const text = printedText(read.job);
  if (line.q !== null && read.cycle.params[line.q]) showPrompt(line.q, read.draft[line.q] ?? "");
  const marked = { ...line, prompt: usePlace.getState().prompt };
  useSelection.setState({ ...NOTHING_SELECTED, line: marked });
  // Reading a program is fetched when a line is first pointed at: to type values nothing of it is needed.
  const { choiceOfBlock } = await import("./block-choice.ts");
  if (useSelection.getState().line !== marked) return;
  const { pictured: shown } = useOutcome.getState();
  const choice = choiceOfBlock(text, line.block);
  if (choice) chooseLine(shown?.text === text ? shown.run : null, choice, marked);
}

/** The line that is marked in the program: the one pointed at, or that of the open prompt in its place. */
export function useChosenLine(read: JobReading): ChosenLine | null {
  const line = useSelection((s) => s.line);
  const prompt = usePlace((p) => p.prompt);
  const shown = useOutcome((s) => s.pictured);
  if (line && line.prompt === prompt) return line;
  const definition = shown?.run.operations[0]?.definedIn;
  return definition === undefined || prompt === null || !read.cycle.params[prompt]
    ? null
    : { block: definition, q: prompt };
}

/** A move was pointed at in the picture: the prompt that decides most about it opens. */
export function openAsked(read: JobReading, step: number, byKey = false): void {
  // Beside the contour table its element is chosen, and it stays.
  if (usePlace.getState().section === "contour") return;
  const { pictured: shown } = useOutcome.getState();
  const { operation = null, move } = shown?.run.steps[step] ?? {};
  const q = operation === null || !move ? null : askedByMove(read.cycle.params, move);
  if (q === null) return showSection("prompts");
  const before = read.draft[q] ?? "";
  if (byKey) openPrompt(q, before);
  else showPrompt(q, before);
}
