import { use, useDeferredValue } from "react";
import type { OfflineTexts } from "../../i18n/en/offline.ts";
import type { Language } from "../../i18n/languages.ts";
import { loadOffline } from "../../i18n/load-offline.ts";
import { untilHere } from "../parts.ts";
import { useSettings } from "../settings/settings.ts";

const coming = new Map<Language, Promise<OfflineTexts>>();

/** The texts of the copy on the device. After a language switch the old ones stay until the new ones are here, so that nothing jumps. */
export function useOfflineTexts(): OfflineTexts {
  const language = useDeferredValue(useSettings((s) => s.language));
  const texts = coming.get(language) ?? untilHere(() => loadOffline(language));
  coming.set(language, texts);
  return use(texts);
}
