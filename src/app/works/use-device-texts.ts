import { use, useDeferredValue } from "react";
import { loadDevice } from "../../i18n/load-device.ts";
import type { DeviceTexts } from "../../i18n/en/device.ts";
import type { Language } from "../../i18n/languages.ts";
import { untilHere } from "../parts.ts";
import { useSettings } from "../settings/settings.ts";

const coming = new Map<Language, Promise<DeviceTexts>>();

function fetched(language: Language): Promise<DeviceTexts> {
  const made = coming.get(language) ?? untilHere(() => loadDevice(language));
  coming.set(language, made);
  return made;
}

/** The texts about the works of this device in the screen language; after a switch the old ones stay until the new ones are here. */
export const useDeviceTexts = (): DeviceTexts => use(fetched(useDeferredValue(useSettings((s) => s.language))));
