import type { SheetTexts } from "./en/sheet.ts";
import type { Language } from "./languages.ts";

/** The texts of the setup sheet, fetched when one is shown. */
export async function loadSheet(language: Language): Promise<SheetTexts> {
  switch (language) {
    case "en":
      return (await import("./en/sheet.ts")).sheet;
    case "de":
      return (await import("./de/sheet.ts")).sheet;
    case "fr":
      return (await import("./fr/sheet.ts")).sheet;
    case "zh":
      return (await import("./zh/sheet.ts")).sheet;
  }
}
