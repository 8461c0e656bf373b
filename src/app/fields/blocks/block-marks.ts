import { RangeSet, StateEffect, type Range, StateField, type EditorState, type Extension } from "@codemirror/state";
import { Decoration, EditorView, GutterMarker, gutter, type DecorationSet } from "@codemirror/view";
import { blockNumbers } from "../../../nc/program.ts";
import { blockAt } from "../../../nc/reread.ts";
import { blockRange, cursorBlock, readingField } from "./reading-field.ts";

/** Marks the block of the running move; null clears the mark. */
export const setRunning = StateEffect.define<number | null>();

const openLine = Decoration.line({ class: "nc-open" });
const runningLine = Decoration.line({ class: "nc-running", attributes: { "aria-current": "step" } });

function linesOf(state: EditorState, index: number | null, mark: Decoration): DecorationSet {
  const range = index === null ? null : blockRange(state, index);
  if (!range) return Decoration.none;
  const lines = [];
  for (let at = range.from; at <= range.to;) {
    const line = state.doc.lineAt(at);
    lines.push(mark.range(line.from));
    at = line.to + 1;
  }
  return Decoration.set(lines);
}

/** All lines of the block at the cursor. */
const openBlock = EditorView.decorations.compute(["doc", "selection"], (state) =>
  linesOf(state, cursorBlock(state), openLine),
);

const runningField = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(marks, tr) {
    for (const effect of tr.effects) if (effect.is(setRunning)) return linesOf(tr.state, effect.value, runningLine);
    return tr.docChanged ? Decoration.none : marks;
  },
  provide: (field) => EditorView.decorations.from(field),
});

const optionalLine = Decoration.line({ class: "nc-optional" });

/** Visible lines of blocks with a skip mark, which are not run while the switch is on. */
function optionalIn({ state, visibleRanges }: EditorView): DecorationSet {
  const reading = state.field(readingField);
  const { program, starts } = reading;
  const lines: Range<Decoration>[] = [];
  for (const { from, to } of visibleRanges) {
    for (let i = Math.max(0, blockAt(reading, from)); i < starts.length && (starts[i] ?? to) <= to; i += 1) {
      const range = program.blocks[i]?.skip ? blockRange(state, i) : null;
      for (let at = range?.from ?? Infinity; range && at <= range.to;) {
        const line = state.doc.lineAt(at);
        lines.push(optionalLine.range(line.from));
        at = line.to + 1;
      }
    }
  }
  return Decoration.set(lines, true);
}

const optionalBlocks = EditorView.decorations.of(optionalIn);

class NumberMarker extends GutterMarker {
  constructor(readonly text: string) {
    super();
  }
  override eq(other: GutterMarker): boolean {
    return other instanceof NumberMarker && other.text === this.text;
  }
  override toDOM(): Text {
    return document.createTextNode(this.text);
  }
}

/** Counted numbers for blocks without a printed one. */
const countedNumbers = gutter({
  class: "nc-counted",
  lineMarker(view, line) {
    const reading = view.state.field(readingField);
    const index = blockAt(reading, line.from);
    const block = reading.program.blocks[index];
    if (!block || reading.starts[index] !== line.from || block.number !== null) return null;
    if (block.statement.kind === "empty" || block.statement.kind === "comment") return null;
    return new NumberMarker(String(blockNumbers(reading.program)[index] ?? ""));
  },
  lineMarkerChange: (update) => update.state.field(readingField) !== update.startState.field(readingField),
  markers: () => RangeSet.empty,
});

export const blockMarks: Extension = [openBlock, runningField, optionalBlocks, countedNumbers];
