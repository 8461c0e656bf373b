import { loadToolWords } from "../../i18n/load-tool-words.ts";
import { laterTexts } from "../../app/base/settings/later-texts.ts";

/** Texts of the tool table that come with it, in the screen language; null until they are here. */
export const { useThemSoon: useToolWords } = laterTexts(loadToolWords);
