import { historyField } from "@codemirror/commands";
import { EditorState, type Extension } from "@codemirror/state";

/** What outlasts a reload of a text, beside itself and its cursor. */
const KEPT = { history: historyField };

/** History and cursor of a text as a file can hold them; the text itself lies with its work. */
export const writtenState = (state: EditorState): unknown => ({ ...(state.toJSON(KEPT) as object), doc: "" });

/** The same text with that history and cursor. Throws where they are none of it. */
export const withHistory = (written: unknown, { doc }: EditorState, extensions: Extension): EditorState =>
  EditorState.fromJSON({ ...(written as object), doc: doc.toString() }, { extensions }, KEPT);
