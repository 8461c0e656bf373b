import { loadHanded } from "../../i18n/load-handed.ts";
import { laterTexts } from "../../app/base/settings/later-texts.ts";

/** The texts of works that are handed on, in the screen language; null until they are here. */
export const { useThemSoon: useHandedTexts } = laterTexts(loadHanded);
