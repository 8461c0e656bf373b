import type { LoadTexts } from "./en/load.ts";
import type { Language } from "./languages.ts";

/** The texts of roughness and load by colour, fetched when they are first shown. */
export async function loadLoad(language: Language): Promise<LoadTexts> {
  switch (language) {
    case "en":
      return (await import("./en/load.ts")).load;
    case "de":
      return (await import("./de/load.ts")).load;
    case "fr":
      return (await import("./fr/load.ts")).load;
    case "zh":
      return (await import("./zh/load.ts")).load;
  }
}
