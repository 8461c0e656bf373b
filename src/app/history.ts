import { draftOf } from "./edits.ts";
import { openPrompt, usePlace } from "./place.ts";
import { readJob } from "./reading.ts";
import { useProgramHistory } from "./program-history.ts";
import { redo, undo, useEditor } from "./store.ts";
import { redoToolStep, undoToolStep } from "./tools/tool-edits.ts";
import { useToolPlace } from "./tools/tool-place.ts";

/** Opens the prompt whose value has just been undone or redone, so that the change is seen. */
function showChange(run: () => void): void {
  const before = useEditor.getState().job;
  run();
  const after = useEditor.getState().job;
  if (!before || !after || before === after) return;
  if (before.cycle !== after.cycle) return;
  const now = draftOf(after);
  const then = draftOf(before);
  const read = readJob(after);
  const changed = read && Object.keys(read.cycle.params).find((q) => (now[q] ?? "") !== (then[q] ?? ""));
  if (changed && (usePlace.getState().section === "prompts")) openPrompt(changed, now[changed] ?? "");
}

/** One step back: in the tool table while it is shown, in the open program by its own history, otherwise in the work. */
export function undoStep(): void {
  if (useToolPlace.getState().shown) undoToolStep();
  else if (useEditor.getState().program) useProgramHistory.getState().undo();
  else showChange(undo);
}

export function redoStep(): void {
  if (useToolPlace.getState().shown) redoToolStep();
  else if (useEditor.getState().program) useProgramHistory.getState().redo();
  else showChange(redo);
}

/** Ctrl+Z, Ctrl+Y, Ctrl+Shift+Z anywhere on the page; fields leave their own undo to this one. */
export function onHistoryKey(event: KeyboardEvent): void {
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
  const key = event.key.toLowerCase();
  if (key !== "z" && key !== "y") return;
  event.preventDefault();
  if (key === "y" || event.shiftKey) redoStep();
  else undoStep();
}
