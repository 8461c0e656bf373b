import { use } from "react";
import type { Texts } from "../../i18n/index.ts";
import { fetchTexts, textsHere } from "./loaded-texts.ts";
import { useSettings } from "./settings.ts";

/** All texts of the screen language, where there is more than the first screen; a component that uses this follows the language switch. */
export function useTexts(): Texts {
  const language = useSettings((s) => s.language);
  return textsHere(language) ?? use(fetchTexts(language));
}
