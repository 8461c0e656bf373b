import type { FirstTexts } from "../../../i18n/first-texts.ts";
import { firstTexts } from "./loaded-texts.ts";
import { useSettings } from "./settings.ts";

/** What the first screen and the top line say in the screen language; follows the language switch. */
export const useFirstTexts = (): FirstTexts => firstTexts(useSettings((s) => s.language));
