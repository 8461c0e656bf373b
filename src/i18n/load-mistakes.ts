import type { Language } from "./languages.ts";
import type { MistakesTexts } from "./mistakes-text.ts";

/** Common mistakes, fetched when the page of a parameter is shown. */
export async function loadMistakes(language: Language): Promise<MistakesTexts> {
  switch (language) {
    case "en":
      return (await import("./en/mistakes.ts")).mistakes;
    case "de":
      return (await import("./de/mistakes.ts")).mistakes;
    case "fr":
      return (await import("./fr/mistakes.ts")).mistakes;
    case "zh":
      return (await import("./zh/mistakes.ts")).mistakes;
  }
}
