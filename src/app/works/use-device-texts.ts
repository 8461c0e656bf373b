import { use } from "react";
import { loadDevice } from "../../i18n/load-device.ts";
import type { DeviceTexts } from "../../i18n/en/device.ts";
import type { Language } from "../../i18n/languages.ts";
import { useSettings } from "../settings/settings.ts";

const coming = new Map<Language, Promise<DeviceTexts>>();

function fetched(language: Language): Promise<DeviceTexts> {
  const known = coming.get(language);
  if (known) return known;
  const made = loadDevice(language);
  coming.set(language, made);
  made.catch(() => coming.delete(language));
  return made;
}

/** The texts about the works of this device in the screen language; what uses them waits for them. */
export const useDeviceTexts = (): DeviceTexts => use(fetched(useSettings((s) => s.language)));
