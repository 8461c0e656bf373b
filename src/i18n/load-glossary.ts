import type { GlossaryTexts } from "./glossary-text.ts";
import type { Language } from "./languages.ts";

/** The glossary, fetched when one of its words is shown. */
export async function loadGlossary(language: Language): Promise<GlossaryTexts> {
  switch (language) {
    case "en":
      return (await import("./en/glossary.ts")).glossary;
    case "de":
      return (await import("./de/glossary.ts")).glossary;
    case "fr":
      return (await import("./fr/glossary.ts")).glossary;
    case "zh":
      return (await import("./zh/glossary.ts")).glossary;
  }
}
