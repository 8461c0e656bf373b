import { loadClamping } from "../../../i18n/load-clamping.ts";
import { laterTexts } from "../../base/settings/later-texts.ts";
import "./clamping.css";

/** The texts of clampings, in the screen language; null until they are here. */
export const { useThemSoon: useClampingTexts } = laterTexts(loadClamping);
