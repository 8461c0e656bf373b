import type { GuidePlacesTexts } from "./en/guide-places.ts";
import type { Language } from "./languages.ts";

/** The texts of the pages for prompts that are no parameter, fetched when one is shown. */
export async function loadGuidePlaces(language: Language): Promise<GuidePlacesTexts> {
  switch (language) {
    case "en":
      return (await import("./en/guide-places.ts")).guidePlaces;
    case "de":
      return (await import("./de/guide-places.ts")).guidePlaces;
    case "fr":
      return (await import("./fr/guide-places.ts")).guidePlaces;
    case "zh":
      return (await import("./zh/guide-places.ts")).guidePlaces;
  }
}
