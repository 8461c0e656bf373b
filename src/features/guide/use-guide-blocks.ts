import { loadGuideBlocks } from "../../i18n/load-guide-blocks.ts";
import { laterTexts } from "../../app/base/settings/later-texts.ts";

/** The texts of the pages for the blocks of a program, in the screen language. */
export const { useThem: useGuideBlocks } = laterTexts(loadGuideBlocks);
