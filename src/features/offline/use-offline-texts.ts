import { loadOffline } from "../../i18n/load-offline.ts";
import { laterTexts } from "../../app/base/settings/later-texts.ts";

/** The texts of the copy on the device, in the screen language. */
export const { useThem: useOfflineTexts } = laterTexts(loadOffline);
