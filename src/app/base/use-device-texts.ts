import { loadDevice } from "../../i18n/load-device.ts";
import { laterTexts } from "./settings/later-texts.ts";

/** The texts about the works of this device, in the screen language. */
export const { useThem: useDeviceTexts } = laterTexts(loadDevice);
