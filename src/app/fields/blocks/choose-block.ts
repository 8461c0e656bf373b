import { blockSpan } from "../../../program/run/block-span.ts";
import type { PathChoice } from "../../../program/run/path-index.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import { shownOtherFile } from "../../document/shown-file.ts";
import { trackOf } from "../../../view/playback.ts";
import { playback } from "../../calculation/playback.ts";
import { useSelection } from "../../document/selected.ts";
import { choosePath } from "../../pictures/selection.ts";
import { isUpToDate } from "./up-to-date.ts";
import { blockRange } from "./reading-field.ts";
import { sessionView, useSession } from "./session.ts";

/** The path of the open block; null if no block is open. */
function choiceOfOpenBlock(): PathChoice | null {
  const view = sessionView();
  const {
    index,
    reading: { program },
  } = useSession.getState();
  const range = view && blockRange(view.state, index);
  if (!range) return null;
  const line = view.state.doc.lineAt(range.from).number;
  const file = shownOtherFile()?.name;
  if (file !== undefined) return { kind: "inFile", file, line };
  return { kind: "blocks", span: blockSpan(program, index), line };
}

/** True while a block opens because its path was chosen; the tool then stays where it is. */
let isChosen = false;

/** Opens a block that was chosen in the picture, without choosing it again. */
export function openChosen(open: () => void): void {
  isChosen = true;
  try {
    open();
  } finally {
    isChosen = false;
  }
}

/** Chooses the open block: marks its path and moves the tool to its start. */
export function chooseOpenBlock(): void {
  const { pictured: shown, newest } = useOutcome.getState();
  const choice = isChosen ? null : choiceOfOpenBlock();
  if (!choice) return;
  choosePath(isUpToDate(shown) ? shown.run : null, choice);
  if (!isUpToDate(shown) && !newest) useSelection.setState({ isEarly: true });
}

/**
 * Called for a new run. Marks the open block, whose index may have changed, or makes the choice that came before the
 * first run.
 */
export function followOpenBlock(): void {
  const { choice, isEarly } = useSelection.getState();
  if (isEarly) useSelection.setState({ isEarly: false });
  if (choice?.kind !== "blocks" && choice?.kind !== "inFile") return;
  if (isEarly) {
    const { pictured } = useOutcome.getState();
    // The picture is not drawn yet, but the steps of its run are known, so playback can seek.
    if (isUpToDate(pictured) && pictured.run.steps.length > 0)
      playback.dispatch({ do: "load", track: trackOf(pictured.run.steps) });
    return chooseOpenBlock();
  }
  const now = choiceOfOpenBlock();
  if (now) useSelection.setState({ choice: now });
}
