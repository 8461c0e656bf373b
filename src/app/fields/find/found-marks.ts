import { RangeSetBuilder, StateEffect, StateField, type Extension } from "@codemirror/state";
import { Decoration, ViewPlugin, type DecorationSet, type EditorView, type ViewUpdate } from "@codemirror/view";
import { matchesIn, type Match } from "./text-search.ts";

/** What is searched, and the occurrence that is shown. */
interface Search {
  readonly sought: string;
  readonly shown: Match | null;
}

/** Marks every occurrence of a text; an empty one ends the search. */
export const setSearch = StateEffect.define<Search>();

const searchField = StateField.define<Search>({
  create: () => ({ sought: "", shown: null }),
  update(search, tr) {
    for (const effect of tr.effects) if (effect.is(setSearch)) return effect.value;
    const { shown } = search;
    return tr.docChanged && shown
      ? { ...search, shown: { from: tr.changes.mapPos(shown.from, 1), to: tr.changes.mapPos(shown.to, -1) } }
      : search;
  },
});

const found = Decoration.mark({ class: "nc-found" });
const shownMark = Decoration.mark({ class: "nc-found shown" });

/** Occurrences in the visible lines. */
function marksIn({ state, visibleRanges }: EditorView): DecorationSet {
  const { sought, shown } = state.field(searchField);
  const marks = new RangeSetBuilder<Decoration>();
  if (sought === "") return Decoration.none;
  let done = -1;
  for (const range of visibleRanges) {
    const start = Math.max(done, state.doc.lineAt(range.from).from);
    const text = state.sliceDoc(start, state.doc.lineAt(range.to).to);
    for (const { from, to } of matchesIn(text, sought)) {
      const at = start + from;
      marks.add(at, start + to, at === shown?.from ? shownMark : found);
    }
    done = start + text.length;
  }
  return marks.finish();
}

const markPlugin = ViewPlugin.fromClass(
  class {
    decorations: DecorationSet;
    constructor(view: EditorView) {
      this.decorations = marksIn(view);
    }
    update({ docChanged, viewportChanged, startState, state, view }: ViewUpdate) {
      if (docChanged || viewportChanged || startState.field(searchField) !== state.field(searchField))
        this.decorations = marksIn(view);
    }
  },
  { decorations: (plugin) => plugin.decorations },
);

export const foundMarks: Extension = [searchField, markPlugin];
