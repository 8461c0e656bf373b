import { useEffect, useState } from "react";
import type { HandedTexts } from "../../i18n/en/handed.ts";
import { loadHanded } from "../../i18n/load-handed.ts";
import { untilHere } from "../parts.ts";
import { useSettings } from "../settings/settings.ts";

/** The texts of works that are handed on, in the screen language; null until they are here. */
export function useHandedTexts(): HandedTexts | null {
  const language = useSettings((s) => s.language);
  const [words, say] = useState<HandedTexts | null>(null);
  useEffect(() => {
    let gone = false;
    void untilHere(() => loadHanded(language)).then((loaded) => {
      if (!gone) say(loaded);
    });
    return () => {
      gone = true;
    };
  }, [language]);
  return words;
}
