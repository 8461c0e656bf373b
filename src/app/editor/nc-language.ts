import { HighlightStyle, StreamLanguage, syntaxHighlighting } from "@codemirror/language";
import type { Extension } from "@codemirror/state";
import { tags } from "@lezer/highlight";
import { tokensOf, type Token, type TokenKind } from "../../nc/tokens.ts";

interface LineState {
  tokens: readonly Token[];
}

const TAGS = {
  number: tags.labelName,
  keyword: tags.keyword,
  parameter: tags.variableName,
  value: tags.number,
  word: tags.attributeName,
  comment: tags.comment,
  structure: tags.heading,
  string: tags.string,
  name: tags.className,
  mark: tags.punctuation,
} as const satisfies Readonly<Record<TokenKind, unknown>>;

/** Klartext, coloured line by line by the reader's own scanner. */
const language = StreamLanguage.define<LineState>({
  name: "klartext",
  startState: () => ({ tokens: [] }),
  copyState: (state) => ({ ...state }),
  token(stream, state) {
    if (stream.sol()) state.tokens = tokensOf(stream.string);
    const next = state.tokens.find((t) => t.to > stream.pos);
    if (!next) stream.skipToEnd();
    else if (next.from > stream.pos) stream.pos = next.from;
    else {
      stream.pos = next.to;
      return next.kind;
    }
    return null;
  },
  tokenTable: TAGS,
});

const style = HighlightStyle.define(Object.entries(TAGS).map(([kind, tag]) => ({ tag, class: `nc-${kind}` })));

export const klartext: Extension = [language, syntaxHighlighting(style)];
