import type { Action } from "../base/actions.ts";
import { draftOf } from "./edits.ts";
import { openPrompt, shownPage, showOwn, showTools, uncoverAll, usePlace } from "../place/place.ts";
import { useOwn } from "./own-store.ts";
import { redo, undo, useSteps, type Way } from "./steps.ts";
import { useEditor } from "./store.ts";
import { useTools } from "./tool-store.ts";

/** The id of an entry that is new in a list. */
const changedIn = <E extends { readonly id: string }>(list: readonly E[], before: readonly E[]): string | undefined =>
  list.find((entry) => !before.includes(entry))?.id;

/**
 * Goes one step through the history and shows the change: a row of the tools, an own cycle, or the work with the
 * prompt. The page of the parameter and the setup sheet stay open: they show the change themselves.
 */
function goAndShow(way: Way, run: () => void): void {
  if (useSteps.getState()[way].length === 0) return;
  const [{ job: before }, { list: toolsBefore }, { list: ownBefore }] = [
    useEditor.getState(),
    useTools.getState(),
    useOwn.getState(),
  ];
  run();
  const [{ job }, { list: tools }, { list: own }] = [useEditor.getState(), useTools.getState(), useOwn.getState()];
  const [now, then] = [job && draftOf(job), before && draftOf(before)];
  const isSameWork = now && then && job !== before && job?.cycle === before?.cycle;
  const prompt = isSameWork
    ? Object.keys({ ...now, ...then }).find((q) => (now[q] ?? "") !== (then[q] ?? ""))
    : undefined;
  const page = shownPage(usePlace.getState());
  if (prompt !== undefined && page.page === "guide" && page.path.includes(prompt)) return;
  uncoverAll("sheet");
  if (own !== ownBefore) showOwn(changedIn(own, ownBefore));
  else if (tools !== toolsBefore) showTools(changedIn(tools, toolsBefore));
  else if (prompt !== undefined && usePlace.getState().section === "prompts") openPrompt(prompt, now?.[prompt] ?? "");
}

/** Undoes the last change, of any kind. */
export const undoStep = (): void => goAndShow("past", undo);
export const redoStep = (): void => goAndShow("future", redo);

/** Undo and redo anywhere on the page; fields leave their own undo to this one. */
export function historyActions(): readonly Action[] {
  const { past, future } = useSteps.getState();
  return [
    { id: "everywhere.undo", isUnlisted: past.length === 0, run: undoStep },
    { id: "everywhere.redo", isUnlisted: future.length === 0, run: redoStep },
  ];
}
