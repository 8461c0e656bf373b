import type { Action } from "../base/actions.ts";
import { draftOf } from "./edits.ts";
import { COURSE, PARTS, WORKS, workOfDocument } from "./documents.ts";
import { openOwn, openPrompt, openToolRow, shownPage, uncoverAll, usePlace, type Place } from "../place/place.ts";
import { ownRecord, useOwn } from "./own-store.ts";
import { historyOf, redo, undo, type DocumentId, type Way } from "./steps.ts";
import { openDocument, useEditor } from "./store.ts";
import { toolRecord, useTools } from "./tool-store.ts";

/** The document on the page on top: the tool table, the own cycles, the list of works, the course, or the open work. */
export function documentInView(
  place: Place = usePlace.getState(),
  open: DocumentId | null = openDocument(),
): DocumentId | null {
  switch (shownPage(place).page) {
    case "tools":
      return toolRecord.document;
    case "own":
      return ownRecord.document;
    case "plan":
      return PARTS;
    case "start":
    case "works":
      return WORKS;
    case "course":
      return COURSE;
    case "elsewhere":
      return null;
    case "work":
    case "sheet":
    case "guide":
      return open;
  }
}

/** The same, followed. */
export function useDocumentInView(): DocumentId | null {
  const open = useEditor(openDocument);
  return usePlace((place) => documentInView(place, open));
}

/** Marks a dialog of another document than the page, by its name. */
const OF_DIALOG = "data-document";
export const dialogOf = (document: DocumentId) => ({ [OF_DIALOG]: document });

/** Whether a dialog of a document is open: its changes are seen there, wherever the focus is. */
export const hasOpenDialog = (of: DocumentId): boolean =>
  [...document.querySelectorAll("dialog[open]")].some((dialog) => dialog.getAttribute(OF_DIALOG) === of);

/** The document of an element, such as the one with the focus: that of its dialog, or of the page. */
export const documentAt = (element: EventTarget | null): DocumentId | null =>
  (element instanceof Element && element.closest(`[${OF_DIALOG}]`)?.getAttribute(OF_DIALOG)) || documentInView();

/** The id of an entry that is new in a list. */
const changedIn = <E extends { readonly id: string }>(list: readonly E[], before: readonly E[]): string | undefined =>
  list.find((entry) => !before.includes(entry))?.id;

/**
 * Shows what changed in the document in view: a row of the tools, an own cycle, or the work with the prompt. The page
 * of the parameter and the setup sheet stay open: they show the change themselves.
 */
function showChange(run: () => void): void {
  const [{ job: before }, { list: toolsBefore }, { list: ownBefore }] = [
    useEditor.getState(),
    useTools.getState(),
    useOwn.getState(),
  ];
  run();
  const [{ job }, { list: tools }, { list: own }] = [useEditor.getState(), useTools.getState(), useOwn.getState()];
  if (own !== ownBefore) return openOwn(changedIn(own, ownBefore) ?? usePlace.getState().own.row);
  if (tools !== toolsBefore) return openToolRow(changedIn(tools, toolsBefore) ?? usePlace.getState().tools.row);
  const [now, then] = [job && draftOf(job), before && draftOf(before)];
  const isSameCycle = now && then && job !== before && job?.cycle === before?.cycle;
  const prompt = isSameCycle
    ? Object.keys({ ...now, ...then }).find((q) => (now[q] ?? "") !== (then[q] ?? ""))
    : undefined;
  const page = shownPage(usePlace.getState());
  if (prompt !== undefined && page.page === "guide" && page.path.includes(prompt)) return;
  uncoverAll("sheet", "plan");
  if (prompt !== undefined && usePlace.getState().section === "prompts") openPrompt(prompt, now?.[prompt] ?? "");
}

/** Whether a step of a document can be done here: that of a work only while it is open. */
const isWithinReach = (document: DocumentId): boolean =>
  workOfDocument(document) === null || document === openDocument();

/** Goes one step through the history of a document, by default of the one in view. */
function goStep(way: Way, document: DocumentId | null): void {
  if (document === null || !isWithinReach(document) || historyOf(document)[way].length === 0) return;
  const go = () => (way === "past" ? undo : redo)(document);
  if (document === documentInView()) showChange(go);
  else go();
}

/** Undoes the last change of a document. */
export const undoStep = (document: DocumentId | null = documentInView()): void => goStep("past", document);
export const redoStep = (document: DocumentId | null = documentInView()): void => goStep("future", document);

/** Undo and redo anywhere on the page, of the document with the focus; fields leave their own undo to this one. */
export function historyActions(): readonly Action[] {
  const { past, future } = historyOf(documentInView());
  const common = { worksInDialogs: true } as const;
  return [
    { ...common, id: "everywhere.undo", isUnlisted: past.length === 0, run: (at) => undoStep(documentAt(at)) },
    { ...common, id: "everywhere.redo", isUnlisted: future.length === 0, run: (at) => redoStep(documentAt(at)) },
  ];
}
