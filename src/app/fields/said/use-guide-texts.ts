import { loadGuide } from "../../../i18n/load-guide.ts";
import { laterTexts } from "../../base/settings/later-texts.ts";

/** The texts of the guide, in the screen language. */
export const { useThem: useGuideTexts, useThemSoon: useGuideTextsSoon } = laterTexts(loadGuide);
