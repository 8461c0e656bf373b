import { historyField } from "@codemirror/commands";
import { EditorState, type Extension } from "@codemirror/state";
import { fromEditor, type LineEnds } from "./line-ends.ts";

/**
 * The text of a file with its own history. It outlives its editor, so that undo reaches it again when the file is
 * opened again.
 */
export interface HeldText {
  readonly work: string;
  /** Key of its file in the work. */
  readonly file: string;
  readonly ends: LineEnds;
  state: EditorState;
}

/** What a text is held under. */
export const heldAs = ({ work, file }: Pick<HeldText, "work" | "file">): string => `${work} ${file}`;

/** Texts as their files have them: a long one is not put together each time it is asked for. */
const files = new WeakMap<EditorState["doc"], string>();

/** A text as its file has it. */
export function fileText({ state: { doc }, ends }: Pick<HeldText, "state" | "ends">): string {
  const known = files.get(doc) ?? fromEditor(doc.toString(), ends);
  files.set(doc, known);
  return known;
}

/** What outlasts a reload of a text, beside itself and its cursor. */
const KEPT = { history: historyField };

/** History and cursor of a text as a file can hold them; the text itself lies with its work. */
export const writtenState = (state: EditorState): unknown => ({ ...(state.toJSON(KEPT) as object), doc: "" });

/** The same text with that history and cursor. Throws where they are none of it. */
export const withHistory = (written: unknown, { doc }: EditorState, extensions: Extension): EditorState =>
  EditorState.fromJSON({ ...(written as object), doc: doc.toString() }, { extensions }, KEPT);
