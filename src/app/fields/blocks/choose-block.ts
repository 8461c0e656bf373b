import { blockSpan } from "../../../program/run/block-span.ts";
import type { PathChoice } from "../../../program/run/path-index.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import { shownBeside } from "../../document/shown-file.ts";
import { trackOf } from "../../../view/playback.ts";
import { playback } from "../../calculation/playback.ts";
import { useSelection } from "../../document/selected.ts";
import { choosePath } from "../../pictures/selection.ts";
import { isPresent } from "./present.ts";
import { blockRange } from "./reading-field.ts";
import { sessionView, useSession } from "./session.ts";

/** What the open block stands for in the picture; null where no block is open. */
function choiceOfOpenBlock(): PathChoice | null {
  const view = sessionView();
  const {
    index,
    reading: { program },
  } = useSession.getState();
  const range = view && blockRange(view.state, index);
  if (!range) return null;
  const line = view.state.doc.lineAt(range.from).number;
  const file = shownBeside()?.name;
  if (file !== undefined) return { kind: "inFile", file, line };
  return { kind: "blocks", span: blockSpan(program, index), line };
}

/** A block is opened for something that is chosen already: the tool stays where it is. */
let isChosen = false;

/** Opens a block by `open` without choosing it again: it was chosen in the picture. */
export function openChosen(open: () => void): void {
  isChosen = true;
  try {
    open();
  } finally {
    isChosen = false;
  }
}

/** The block that is open in the text is chosen: its path is marked, and the tool goes to where it begins. */
export function chooseOpenBlock(): void {
  const { pictured: shown, newest } = useOutcome.getState();
  const choice = isChosen ? null : choiceOfOpenBlock();
  if (!choice) return;
  choosePath(isPresent(shown) ? shown.run : null, choice);
  if (!isPresent(shown) && !newest) useSelection.setState({ isEarly: true });
}

/**
 * There is another run. Blocks may stand elsewhere in a changed text: what is marked goes along with the open one. What
 * was chosen before there was any is shown now.
 */
export function followOpenBlock(): void {
  const { choice, isEarly } = useSelection.getState();
  if (isEarly) useSelection.setState({ isEarly: false });
  if (choice?.kind !== "blocks" && choice?.kind !== "inFile") return;
  if (isEarly) {
    const { pictured } = useOutcome.getState();
    // The picture is not there yet: the steps of its run are, to be gone to.
    if (isPresent(pictured) && pictured.run.steps.length > 0)
      playback.dispatch({ do: "load", track: trackOf(pictured.run.steps) });
    return chooseOpenBlock();
  }
  const now = choiceOfOpenBlock();
  if (now) useSelection.setState({ choice: now });
}
