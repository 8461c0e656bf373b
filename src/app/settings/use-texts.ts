import type { Texts } from "../../i18n/index.ts";
import { texts } from "./loaded-texts.ts";
import { useSettings } from "./settings.ts";

/** The texts of the screen language; a component that uses this follows the language switch. */
export const useTexts = (): Texts => texts(useSettings((s) => s.language));
