import { StateField, type Extension, type Range, type Text } from "@codemirror/state";
import { Decoration, EditorView, WidgetType, type DecorationSet } from "@codemirror/view";
import { LONGEST_LINE } from "../../../nc/longest-line.ts";

/** Name of the text in place of what is not shown; the phrases of the editor translate it. */
export const HIDDEN_PHRASE = "$ characters";
/** Characters that are shown of a line that is too long to be read. */
const SHOWN = 200;

class HiddenRest extends WidgetType {
  constructor(readonly characters: number) {
    super();
  }
  override eq = (other: HiddenRest) => other.characters === this.characters;
  toDOM({ state }: EditorView): HTMLElement {
    const box = document.createElement("span");
    box.className = "nc-hidden";
    box.textContent = ` … ${state.phrase(HIDDEN_PHRASE, this.characters)}`;
    return box;
  }
}

/** What is not shown of the lines that two places are on, and of those between. */
function hiddenBetween(doc: Text, from: number, to: number): Range<Decoration>[] {
  const made: Range<Decoration>[] = [];
  const first = doc.lineAt(from);
  let begin = first.from;
  for (const line of doc.iterLines(first.number, doc.lineAt(to).number + 1)) {
    const end = begin + line.length;
    if (line.length > LONGEST_LINE)
      made.push(Decoration.replace({ widget: new HiddenRest(line.length - SHOWN) }).range(begin + SHOWN, end));
    begin = end + 1;
  }
  return made;
}

/**
 * A line that is too long to be read is shown by its beginning, so that the browser never has to lay out a
 * megabyte of one line. Only the lines of a change are looked at.
 */
export const longLines: Extension = StateField.define<DecorationSet>({
  create: ({ doc }) => Decoration.set(hiddenBetween(doc, 0, doc.length)),
  update(before, { changes, docChanged, newDoc, reconfigured }) {
    // Another screen language.
    if (reconfigured) return Decoration.set(hiddenBetween(newDoc, 0, newDoc.length));
    if (!docChanged) return before;
    let after = before.map(changes);
    changes.iterChangedRanges((_from, _to, begin, end) => {
      const [filterFrom, filterTo] = [newDoc.lineAt(begin).from, newDoc.lineAt(end).to];
      const add = hiddenBetween(newDoc, filterFrom, filterTo);
      after = after.update({ filterFrom, filterTo, filter: () => false, add });
    });
    return after;
  },
  provide: (field) => [
    EditorView.decorations.from(field),
    EditorView.atomicRanges.of((view) => view.state.field(field)),
  ],
});
