import { decidingParameter } from "../../../cycles/deciding-parameter.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import { openPrompt, showPrompt, showSection, usePlace } from "../../place/place.ts";
import { printedText } from "../../document/printed.ts";
import type { JobReading } from "../../document/reading.ts";
import { NOTHING_SELECTED, useSelection } from "../../document/selected.ts";
import { chooseLine } from "../../pictures/selection.ts";
import type { ChosenLine } from "./ProgramText.tsx";

/** Chooses a program line: marks it and its path, opens its prompt and moves the tool to its block. */
export async function chooseJobLine(read: JobReading, line: ChosenLine): Promise<void> {
  const text = printedText(read.job);
  if (line.q !== null && read.cycle.params[line.q]) showPrompt(line.q, read.draft[line.q] ?? "");
  const marked = { ...line, prompt: usePlace.getState().prompt };
  useSelection.setState({ ...NOTHING_SELECTED, line: marked });
  // The program reader is loaded on the first click; typing values does not need it.
  const { choiceOfBlock } = await import("./block-choice.ts");
  if (useSelection.getState().line !== marked) return;
  const { pictured: shown } = useOutcome.getState();
  const choice = choiceOfBlock(text, line.block);
  if (choice) chooseLine(shown?.text === text ? shown.run : null, choice, marked);
}

/** The marked program line: the clicked one, or that of the open prompt. */
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

/** Opens the prompt that most affects a chosen move. Returns whether the prompt takes the focus. */
export function openAsked(read: JobReading, step: number, byKey = false): boolean {
  // In the contour section the element is chosen instead.
  if (usePlace.getState().section === "contour") return false;
  const { pictured: shown } = useOutcome.getState();
  const { operation = null, move } = shown?.run.steps[step] ?? {};
  const q = operation === null || !move ? null : decidingParameter(read.cycle.params, move);
  if (q === null) showSection("prompts");
  else (byKey ? openPrompt : showPrompt)(q, read.draft[q] ?? "");
  return byKey && q !== null;
}
