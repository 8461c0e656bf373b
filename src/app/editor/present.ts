import { isMadeFrom, type Outcome } from "../engine/outcome.ts";
import { shownFile } from "../files/shown-file.ts";
import { useEditor } from "../store.ts";
import { sessionText } from "./session.ts";

/** True when a result was made from the work as it stands now, the text in the editor included. */
export function isPresent(outcome: Outcome | null): outcome is Outcome {
  const { program } = useEditor.getState();
  return outcome !== null && program !== null && isMadeFrom(outcome, program) && shownFile(program).text === sessionText();
}
