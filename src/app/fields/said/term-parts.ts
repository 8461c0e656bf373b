import { TERMS, type GlossaryTexts, type TermId } from "../../../i18n/glossary-text.ts";
import type { Language } from "../../../i18n/languages.ts";

/** A piece of a text; the word of the glossary that it is, where it is one. */
export interface TermPart {
  readonly text: string;
  readonly term: TermId | null;
}

/** What a word may end with in a sentence, by language; in French each of its words. */
const ENDINGS: Readonly<Record<Language, string>> = { en: "(?:e?s)?", de: "(?:e[nsr]?|n|s|ern)?", fr: "(?:e?s|x)?", zh: "" };
/** Other words that the glossary means as well, by language: what is said of an insert in the shop. */
const ALSO: Partial<Record<Language, Partial<Record<TermId, string>>>> = {
  de: { insert: "Platte", theoreticalTip: "Schneidenspitze", workpieceZero: "Nullpunkt" },
  fr: { blank: "brut", thread: "filet" },
};
/**
 * Words that are a term only in such places: French "pas" is mostly half of "not", "passe" is a verb as well, and what "est plongée" is
 * no plunging.
 */
const WHERE: Partial<Record<Language, Partial<Record<TermId, string>>>> = {
  fr: {
    pitch: "(?<=(?:le|du|un|au|Le|Du|Un|Au) )",
    pass: "(?:(?=passes)|(?<=^|(?:la|une|aucune|chaque|cette|de|par|sans|longue|seule|même|[ei]ère|ième) ))",
    plunging: "(?<!(?:est|sont|être) )",
  },
};
const UMLAUTS: Readonly<Record<string, string>> = { a: "ä", au: "äu", o: "ö", u: "ü" };
const escaped = (text: string) => text.replaceAll(/[.*+?^${}()|[\]\\]/g, String.raw`\$&`);
/** A name without what stands in brackets behind it, each of several apart. */
const namesOf = (name: string) => name.replace(/\s*[（(].*$/u, "").split(/\s*[、,/]\s*/u).filter((each) => each !== "");

/** A German noun with its endings, and its plural where that changes within: Satz, Sätze; Span, Späne; Zyklus, Zyklen. */
function germanForms(name: string): string {
  const umlauted = name.replace(/(au|[aou])(?=[^aeiouäöü]+$)/u, (vowel) => UMLAUTS[vowel] ?? vowel);
  return `(?:${escaped(name)}${ENDINGS.de}|${escaped(umlauted)}en?|${escaped(name.replace(/us$/u, "en"))})`;
}

interface Sought {
  readonly term: TermId;
  readonly form: RegExp;
  readonly long: number;
}

/** How the words of a glossary are found in sentences, the longest first: a nose radius is no radius. */
function soughtIn(glossary: GlossaryTexts, language: Language): readonly Sought[] {
  const word = (each: string) => language === "de" ? germanForms(each) : escaped(each) + ENDINGS[language];
  const formOf = (name: string) => (language === "fr" ? name.split(" ").map(word).join(" ") : word(name));
  const of = (term: TermId): readonly Sought[] =>
    [...namesOf(glossary[term].name), ALSO[language]?.[term] ?? []].flat().map((name) => ({
      term,
      long: name.length,
      // German names are nouns with a capital; a verb that is spelled alike is none.
      form: language === "zh"
        ? new RegExp(escaped(name), "gu")
        : new RegExp(String.raw`${WHERE[language]?.[term] ?? ""}(?<![\p{L}\d-])${formOf(name)}(?![\p{L}\d-])`,
          language === "de" ? "gu" : "giu"),
    }));
  return TERMS.flatMap(of).toSorted((a, b) => b.long - a.long);
}

const known = new WeakMap<GlossaryTexts, readonly Sought[]>();

interface Found {
  readonly from: number;
  readonly to: number;
  readonly term: TermId;
}

/**
 * Texts of a page in the order in which they are read, each in pieces: a word of the glossary is one where it is used first. Words in
 * `before` were used on a page before; `but` is the word that the text itself explains.
 */
export function termParts(
  texts: readonly string[],
  glossary: GlossaryTexts,
  language: Language,
  { before = [], but = null }: { readonly before?: readonly string[]; readonly but?: TermId | null } = {},
): readonly (readonly TermPart[])[] {
  const sought = known.get(glossary) ?? soughtIn(glossary, language);
  known.set(glossary, sought);
  const used = new Set<TermId>(but === null ? [] : [but]);
  const piecesOf = (text: string): readonly TermPart[] => {
    const found: Found[] = [], taken: Found[] = [];
    for (const { term, form } of sought) {
      for (const match of text.matchAll(form)) {
        const at = { from: match.index, to: match.index + match[0].length, term };
        if (taken.some(({ from, to }) => at.from < to && from < at.to)) continue;
        taken.push(at);
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
