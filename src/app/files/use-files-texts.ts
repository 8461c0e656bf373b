import { useEffect, useState } from "react";
import type { FilesTexts } from "../../i18n/en/files.ts";
import { loadFiles } from "../../i18n/load-files.ts";
import { useSettings } from "../settings/settings.ts";

/** What is said about files of the device, in the screen language; null until it is here. */
export function useFilesTexts(): FilesTexts | null {
  const language = useSettings((s) => s.language);
  const [texts, take] = useState<FilesTexts | null>(null);
  useEffect(() => {
    let gone = false;
    void loadFiles(language).then((loaded) => {
      if (!gone) take(loaded);
    });
    return () => {
      gone = true;
    };
  }, [language]);
  return texts;
}
