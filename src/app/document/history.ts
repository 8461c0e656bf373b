import { draftOf } from "./edits.ts";
import { showOpenWork } from "./go-home.ts";
import { useGuidePlace } from "../place/guide-place.ts";
import { openPrompt, usePlace } from "../place/place.ts";
import { showOwn } from "./own-place.ts";
import { useOwn } from "./own-store.ts";
import { OF_WORKS } from "./of-works.ts";
import { redo, undo, useSteps, type Steps } from "./steps.ts";
import { useEditor } from "./store.ts";
import { showTools } from "./tool-place.ts";
import { useTools } from "./tool-store.ts";

/** Goes one step through the history and shows what has changed: a row of the tools, a described cycle, or the work with the prompt. */
function goAndShow(way: keyof Steps, run: () => void): void {
  if (useSteps.getState()[way].length === 0) return;
  // The list of works is not left for another place when a change of it is taken back.
  if (useSteps.getState()[way].at(-1)?.of === OF_WORKS && useEditor.getState().work === null) return run();
  const [{ job: before }, { list: tools }, { list: own }] = [useEditor.getState(), useTools.getState(), useOwn.getState()];
  run();
  const described = useOwn.getState().list;
  if (described !== own) {
    const known = new Set(own);
    showOpenWork();
    return showOwn(described.find((entry) => !known.has(entry))?.id);
  }
  const [{ job: after }, { list }] = [useEditor.getState(), useTools.getState()];
  if (list !== tools) {
    const known = new Set(tools);
    showOpenWork();
    showTools(list.find((entry) => !known.has(entry))?.id);
    return;
  }
  const [now, then] = [after && draftOf(after), before && draftOf(before)];
  const isSameWork = now && then && after !== before && after?.cycle === before?.cycle;
  const changed = isSameWork ? Object.keys({ ...now, ...then }).find((q) => (now[q] ?? "") !== (then[q] ?? "")) : undefined;
  // The page of a parameter shows its value: there the change is seen.
  if (changed !== undefined && useGuidePlace.getState().path?.includes(changed)) return;
  showOpenWork();
  if (changed !== undefined && usePlace.getState().section === "prompts") openPrompt(changed, now?.[changed] ?? "");
}

/** One step back, whatever was changed last. */
export const undoStep = (): void => goAndShow("past", undo);
export const redoStep = (): void => goAndShow("future", redo);

/** Ctrl+Z, Ctrl+Y, Ctrl+Shift+Z anywhere on the page; fields leave their own undo to this one. */
export function onHistoryKey(event: KeyboardEvent): void {
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
  const key = event.key.toLowerCase();
  if (key !== "z" && key !== "y") return;
  event.preventDefault();
  if (key === "y" || event.shiftKey) redoStep();
  else undoStep();
}
