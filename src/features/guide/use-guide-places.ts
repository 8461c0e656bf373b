import { loadGuidePlaces } from "../../i18n/load-guide-places.ts";
import { laterTexts } from "../../app/base/settings/later-texts.ts";

/** The texts of the pages for prompts that are no parameter of a cycle, in the screen language. */
export const { useThem: useGuidePlaces } = laterTexts(loadGuidePlaces);
