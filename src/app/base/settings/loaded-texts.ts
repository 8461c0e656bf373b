import { menuWordsOf } from "virtual:cycle-menu";
import { loadFirst, type FirstTexts } from "../../../i18n/first-texts.ts";
import type { Texts } from "../../../i18n/index.ts";
import type { Language } from "../../../i18n/languages.ts";
import { loadTexts } from "../../../i18n/load.ts";
import { never } from "../../../kernel/never.ts";

/** Texts that are here; those of other languages are fetched when they are chosen. */
const first = new Map<Language, FirstTexts>();
const whole = new Map<Language, Texts>();
/** Whole texts that are on their way. */
const coming = new Map<Language, Promise<Texts>>();
let asked = false;

/** Puts the texts of the first screen in place. */
export function provideFirstTexts(language: Language, texts: FirstTexts): void {
  first.set(language, texts);
}

/** Puts the texts of a language in place. */
export function provideTexts(language: Language, texts: Texts): void {
  whole.set(language, texts);
}

/** Fetches what the first screen says in a language; afterwards `firstTexts` has it. */
export async function fetchFirstTexts(language: Language): Promise<FirstTexts> {
  const known = first.get(language);
  if (known) return known;
  const [written, menu] = await Promise.all([loadFirst(language), menuWordsOf(language)]);
  const made = { ...written, menu };
  provideFirstTexts(language, made);
  return made;
}

/** Fetches all texts of a language; afterwards `texts` has them. */
export function fetchTexts(language: Language): Promise<Texts> {
  asked = true;
  const known = coming.get(language);
  if (known) return known;
  const fetched = loadTexts(language).then((texts) => {
    provideTexts(language, texts);
    return texts;
  });
  coming.set(language, fetched);
  fetched.catch(() => coming.delete(language));
  return fetched;
}

/** What the first screen says in a language that has been fetched. The settings change their language only after that. */
export const firstTexts = (language: Language): FirstTexts => first.get(language) ?? never("a language before its texts", language);

/** All texts of a language; undefined while they are not here. */
export const textsHere = (language: Language): Texts | undefined => whole.get(language);

/** All texts of a language that has been fetched. */
export const texts = (language: Language): Texts => textsHere(language) ?? never("a language before its texts", language);

/** True when the page shows more than the first screen, or is about to, and this language has no texts for that yet. */
export const lacksTexts = (language: Language): boolean => asked && !whole.has(language);
