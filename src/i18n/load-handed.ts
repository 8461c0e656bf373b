import type { HandedTexts } from "./en/handed.ts";
import type { Language } from "./languages.ts";

/** The texts of works that are handed on, fetched when one is. */
export async function loadHanded(language: Language): Promise<HandedTexts> {
  switch (language) {
    case "en":
      return (await import("./en/handed.ts")).handed;
    case "de":
      return (await import("./de/handed.ts")).handed;
    case "fr":
      return (await import("./fr/handed.ts")).handed;
    case "zh":
      return (await import("./zh/handed.ts")).handed;
  }
}
