import type { GuideTexts } from "./en/guide.ts";
import type { Language } from "./languages.ts";

/** The texts of the guide, fetched when something of it is shown. */
export async function loadGuide(language: Language): Promise<GuideTexts> {
  switch (language) {
    case "en":
      return (await import("./en/guide.ts")).guide;
    case "de":
      return (await import("./de/guide.ts")).guide;
    case "fr":
      return (await import("./fr/guide.ts")).guide;
    case "zh":
      return (await import("./zh/guide.ts")).guide;
  }
}
