import { isMadeFrom, type Outcome, type Planned } from "../../calculation/outcome.ts";
import { shownFile } from "../../document/shown-file.ts";
import { useEditor } from "../../document/store.ts";
import { sessionText } from "./session.ts";

/** True if a result belongs to the current work, including the text in the editor. */
export function isUpToDate<Made extends Outcome | Planned>(outcome: Made | null): outcome is Made {
  const { program } = useEditor.getState();
  return (
    outcome !== null && program !== null && isMadeFrom(outcome, program) && shownFile(program).text === sessionText()
  );
}
