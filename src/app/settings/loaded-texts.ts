import type { Texts } from "../../i18n/index.ts";
import type { Language } from "../../i18n/languages.ts";
import { loadTexts } from "../../i18n/load.ts";
import { never } from "../../kernel/never.ts";

/** Languages that are here; the others are fetched when they are chosen. */
const here = new Map<Language, Texts>();

/** Puts the texts of a language in place. */
export function provideTexts(language: Language, texts: Texts): void {
  here.set(language, texts);
}

/** Fetches a language; afterwards `texts` has it. */
export async function fetchTexts(language: Language): Promise<void> {
  if (!here.has(language)) provideTexts(language, await loadTexts(language));
}

/** The texts of a language that has been fetched. The settings change their language only after that. */
export const texts = (language: Language): Texts => here.get(language) ?? never("a language before its texts", language);
