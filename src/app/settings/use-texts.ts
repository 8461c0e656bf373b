import { use } from "react";
import type { Texts } from "../../i18n/index.ts";
import type { Language } from "../../i18n/languages.ts";
import { untilHere } from "../parts.ts";
import { fetchTexts, textsHere } from "./loaded-texts.ts";
import { useSettings } from "./settings.ts";

const coming = new Map<Language, Promise<Texts>>();

/** One promise for a language, which does not fail: what does not come is fetched again. */
function comingTexts(language: Language): Promise<Texts> {
  const known = coming.get(language) ?? untilHere(() => fetchTexts(language));
  coming.set(language, known);
  return known;
}

/** All texts of the screen language, where there is more than the first screen; a component that uses this follows the language switch. */
export function useTexts(): Texts {
  const language = useSettings((s) => s.language);
  return textsHere(language) ?? use(comingTexts(language));
}
