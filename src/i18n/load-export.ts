import type { ExportTexts } from "./en/export.ts";
import type { Language } from "./languages.ts";

/** The texts of the export of the part, fetched when it is opened. */
export async function loadExport(language: Language): Promise<ExportTexts> {
  switch (language) {
    case "en":
      return (await import("./en/export.ts")).exported;
    case "de":
      return (await import("./de/export.ts")).exported;
    case "fr":
      return (await import("./fr/export.ts")).exported;
    case "zh":
      return (await import("./zh/export.ts")).exported;
  }
}
