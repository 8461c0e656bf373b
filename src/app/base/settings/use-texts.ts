import { use } from "react";
import type { Texts } from "../../../i18n/index.ts";
import type { Language } from "../../../i18n/languages.ts";
import { untilHere } from "../parts.ts";
import { atOnce } from "./later-texts.ts";
import { fetchTexts, textsHere } from "./loaded-texts.ts";
import { useSettings } from "./settings.ts";

const coming = new Map<Language, Promise<Texts>>();

/** One promise for a language, which does not fail: what does not come is fetched again. */
function comingTexts(language: Language): Promise<Texts> {
  const made = untilHere(() => fetchTexts(language));
  atOnce(made);
  coming.set(language, made);
  return made;
}

/** All texts of the screen language, where there is more than the first screen; a component that uses this follows the language switch. */
export function useTexts(): Texts {
  const language = useSettings((s) => s.language);
  const asked = coming.get(language);
  return asked ? use(asked) : textsHere(language) ?? use(comingTexts(language));
}
