import type { EditorTexts } from "../../../i18n/en/workplace/editor.ts";
import type { Statement } from "../../../nc/statement.ts";

/** Key of the words that name a kind of block. */
export type BlockKind = keyof EditorTexts["kinds"];

/** What kind of block a statement is, for its name. */
export function kindOf(s: Statement): BlockKind {
  switch (s.kind) {
    case "path":
      return s.path;
    case "approach":
      return s.departing ? "departure" : "approach";
    case "cycleLine":
      return s.cycle === 14 ? "contour" : "cycleLine";
    default:
      return s.kind;
  }
}
