import { useEffect, useState } from "react";
import { loadToolWords } from "../../i18n/load-tool-words.ts";
import { untilHere } from "../parts.ts";
import { useSettings } from "../settings/settings.ts";

type ToolWords = Awaited<ReturnType<typeof loadToolWords>>;

/** Texts of the tool table that come with it; null until they are here. */
export function useToolWords(): ToolWords | null {
  const language = useSettings((s) => s.language);
  const [words, say] = useState<ToolWords | null>(null);
  useEffect(() => {
    let gone = false;
    void untilHere(() => loadToolWords(language)).then((loaded) => {
      if (!gone) say(loaded);
    });
    return () => {
      gone = true;
    };
  }, [language]);
  return words;
}
