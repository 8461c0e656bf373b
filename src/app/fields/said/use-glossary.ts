import { loadGlossary } from "../../../i18n/load-glossary.ts";
import { laterTexts } from "../../base/settings/later-texts.ts";

/** The glossary in the screen language. */
export const { useThem: useGlossary, useThemSoon: useGlossarySoon } = laterTexts(loadGlossary);
