import type { Extension, Range } from "@codemirror/state";
import { Decoration, ViewPlugin, type DecorationSet, type EditorView, type ViewUpdate } from "@codemirror/view";
import { LONGEST_LINE } from "../../../nc/longest-line.ts";
import { tokensOf, type Token, type TokenKind } from "../../../nc/tokens.ts";

const KINDS = [
  "number",
  "keyword",
  "parameter",
  "value",
  "word",
  "comment",
  "structure",
  "string",
  "name",
  "mark",
] as const satisfies readonly TokenKind[];
const marks = Object.fromEntries(KINDS.map((kind) => [kind, Decoration.mark({ class: `nc-${kind}` })])) as Readonly<
  Record<TokenKind, Decoration>
>;

/** Where the sign of a block that goes on begins, with the blank before it: never alone in a row. -1 without one. */
function continuedAt(line: string): number {
  const marked = line.trimEnd();
  const bare = marked.endsWith("~") ? marked.slice(0, -1).trimEnd() : marked;
  return bare.length < marked.length - 1 ? bare.length : -1;
}
const continued = Decoration.mark({ class: "nc-continued" });

/** Cache of scanned lines, and its size. */
const known = new Map<string, readonly Token[]>();
const MOST = 2000;

/** A line that is too long to be read has no colours. */
function wordsOf(line: string): readonly Token[] {
  if (line.length > LONGEST_LINE) return [];
  const words = known.get(line) ?? tokensOf(line);
  if (known.size >= MOST) known.clear();
  known.set(line, words);
  return words;
}

/** Colours of the visible lines. Each line can be scanned on its own. */
function coloured({ state: { doc }, visibleRanges }: EditorView): DecorationSet {
  const made: Range<Decoration>[] = [];
  for (const { from, to } of visibleRanges) {
    for (let line = doc.lineAt(from); ; line = doc.line(line.number + 1)) {
      for (const word of wordsOf(line.text))
        if (word.to > word.from) made.push(marks[word.kind].range(line.from + word.from, line.from + word.to));
      const sign = continuedAt(line.text);
      if (sign >= 0) made.push(continued.range(line.from + sign, line.to));
      if (line.to >= to) break;
    }
  }
  return Decoration.set(made, true);
}

/** Syntax colouring for Klartext, with the scanner of the reader. */
export const klartext: Extension = ViewPlugin.fromClass(
  class {
    decorations: DecorationSet;
    constructor(view: EditorView) {
      this.decorations = coloured(view);
    }
    update({ docChanged, viewportChanged, view }: ViewUpdate) {
      if (docChanged || viewportChanged) this.decorations = coloured(view);
    }
  },
  { decorations: (plugin) => plugin.decorations },
);
