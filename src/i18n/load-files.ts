import type { FilesTexts } from "./en/files.ts";
import type { Language } from "./languages.ts";

/** The texts of files of the device, fetched when something is to be asked about them. */
export async function loadFiles(language: Language): Promise<FilesTexts> {
  switch (language) {
    case "en":
      return (await import("./en/files.ts")).files;
    case "de":
      return (await import("./de/files.ts")).files;
    case "fr":
      return (await import("./fr/files.ts")).files;
    case "zh":
      return (await import("./zh/files.ts")).files;
  }
}
