import type { Language } from "./languages.ts";
import type { WhichTexts } from "./which-text.ts";

/** The texts of the question which cycle makes a shape, fetched when it is asked. */
export async function loadWhich(language: Language): Promise<WhichTexts> {
  switch (language) {
    case "en":
      return (await import("./en/which.ts")).which;
    case "de":
      return (await import("./de/which.ts")).which;
    case "fr":
      return (await import("./fr/which.ts")).which;
    case "zh":
      return (await import("./zh/which.ts")).which;
  }
}
