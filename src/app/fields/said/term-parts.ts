import { TERMS, type GlossaryTexts, type TermId } from "../../../i18n/glossary-text.ts";

/** A piece of text, and its glossary term if it is one. */
export interface TermPart {
  readonly text: string;
  readonly term: TermId | null;
}

const escaped = (text: string) => text.replaceAll(/[.*+?^${}()|[\]\\]/g, String.raw`\$&`);
/** Splits a name into its alternatives, without the part in brackets. */
const namesOf = (name: string) =>
  name
    .replace(/[（(].*/u, "")
    .split(/[、,/]/u)
    .map((each) => each.trim())
    .filter((each) => each !== "");

interface TermPattern {
  readonly term: TermId;
  readonly form: RegExp;
  readonly long: number;
}

/** Patterns of all terms, longest first, so that "nose radius" is not found as "radius". */
function termPatterns(glossary: GlossaryTexts): readonly TermPattern[] {
  const { formsOf, capitals, apart } = glossary.words;
  const [before, behind] = apart ? [String.raw`(?<![\p{L}\d-])`, String.raw`(?![\p{L}\d-])`] : ["", ""];
  const of = (term: TermId): readonly TermPattern[] => {
    const { name, also = [], where = "" } = glossary[term];
    return [...namesOf(name), also].flat().map((each) => ({
      term,
      long: each.length,
      form: new RegExp(`${where}${before}${formsOf(escaped(each))}${behind}`, capitals ? "gu" : "giu"),
    }));
  };
  return TERMS.flatMap(of).toSorted((a, b) => b.long - a.long);
}

const known = new WeakMap<GlossaryTexts, readonly TermPattern[]>();

interface TermMatch {
  readonly from: number;
  readonly to: number;
  readonly term: TermId;
}

/**
 * Splits the texts of a page, in reading order, into pieces; a term counts at its first use. `before`: texts of
 * previous pages. `but`: term that the text itself explains.
 */
export function termParts(
  texts: readonly string[],
  glossary: GlossaryTexts,
  { before = [], but = null }: { readonly before?: readonly string[]; readonly but?: TermId | null } = {},
): readonly (readonly TermPart[])[] {
  const sought = known.get(glossary) ?? termPatterns(glossary);
  known.set(glossary, sought);
  const used = new Set<TermId>(but === null ? [] : [but]);
  const piecesOf = (text: string): readonly TermPart[] => {
    const found: TermMatch[] = [],
      taken = new Uint8Array(text.length);
    for (const { term, form } of sought) {
      for (const match of text.matchAll(form)) {
        const at = { from: match.index, to: match.index + match[0].length, term };
        if (taken.subarray(at.from, at.to).includes(1)) continue;
        taken.fill(1, at.from, at.to);
        found.push(at);
      }
    }
    const parts: TermPart[] = [];
    let end = 0;
    for (const { from, to, term } of found.toSorted((a, b) => a.from - b.from)) {
      if (used.has(term)) continue;
      used.add(term);
      if (from > end) parts.push({ text: text.slice(end, from), term: null });
      parts.push({ text: text.slice(from, to), term });
      end = to;
    }
    return end < text.length ? [...parts, { text: text.slice(end), term: null }] : parts;
  };
  before.forEach(piecesOf);
  return texts.map(piecesOf);
}
