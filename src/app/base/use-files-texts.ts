import { loadFiles } from "../../i18n/load-files.ts";
import { laterTexts } from "./settings/later-texts.ts";

/** What is said about files of the device, in the screen language; null until it is here. */
export const { useThemSoon: useFilesTexts } = laterTexts(loadFiles);
