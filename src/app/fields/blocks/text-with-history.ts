import { historyField } from "@codemirror/commands";
import { EditorState, type ChangeSet, type Extension } from "@codemirror/state";
import type { JournalText } from "../../records/journal.ts";
import { fromEditor, type LineEnds } from "./line-ends.ts";

/**
 * The text of a file with its undo history. It outlives its editor, so undo still works when the file is opened again.
 */
export interface TextWithHistory {
  readonly work: string;
  /** Key of its file in the work. */
  readonly file: string;
  readonly ends: LineEnds;
  state: EditorState;
  /** Changes that its work does not have yet. */
  unflushed: ChangeSet | null;
}

/** Key of a text in the cache. */
export const textKey = ({ work, file }: Pick<TextWithHistory, "work" | "file">): string => `${work} ${file}`;

/** File texts by document, so that a long text is joined only once. */
const files = new WeakMap<EditorState["doc"], string>();

/** The text with the line ends of its file. */
export function fileText({ state: { doc }, ends }: Pick<TextWithHistory, "state" | "ends">): string {
  const known = files.get(doc) ?? fromEditor(doc.toString(), ends);
  files.set(doc, known);
  return known;
}

/** Changes of the text as one change of its file. */
export function changeInFile({ state: { doc }, ends }: TextWithHistory, changes: ChangeSet): JournalText {
  let [from, to] = [doc.length, 0];
  changes.iterChangedRanges((_, __, fromB, toB) => {
    from = Math.min(from, fromB);
    to = Math.max(to, toB);
  });
  const perEnd = ends === "mixed" ? 0 : ends.length - 1;
  const after = doc.length - to + (doc.lines - doc.lineAt(to).number) * perEnd;
  return [from + (doc.lineAt(from).number - 1) * perEnd, after, fromEditor(doc.sliceString(from, to), ends)];
}

/** Editor state that survives a reload, besides text and cursor. */
const KEPT = { history: historyField };

/** History and cursor as JSON; the text itself is stored with its work. */
export const serializedState = (state: EditorState): unknown => ({ ...(state.toJSON(KEPT) as object), doc: "" });

/** The same text with that history and cursor. Throws if they do not fit the text. */
export const restoredState = (written: unknown, { doc }: EditorState, extensions: Extension): EditorState =>
  EditorState.fromJSON({ ...(written as object), doc: doc.toString() }, { extensions }, KEPT);
