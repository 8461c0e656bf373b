import type { Language } from "../../src/i18n/languages.ts";
import type { PartTexts } from "../../src/i18n/parts.ts";
import { readWords, type Name, type Parts } from "./read-words.ts";

const loaded = new Map<Language, Parts>();

/** Loads the texts of a language once. */
export async function loadWords(language: Language): Promise<void> {
  if (!loaded.has(language)) loaded.set(language, await readWords(language));
}
await loadWords("en");

/** The page texts of a language that is loaded. */
export function words<N extends Name>(language: Language, name: N): PartTexts<N> {
  const parts = loaded.get(language);
  if (!parts) throw new Error(`The texts of "${language}" are not loaded: await Turnwise.load("${language}") first.`);
  return parts[name];
}
