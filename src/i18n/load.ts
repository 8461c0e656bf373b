import type { Language } from "./languages.ts";
import type { Texts } from "./index.ts";

/** The texts of one language, fetched when it is chosen: a page loads only the language that it shows. */
export async function loadTexts(language: Language): Promise<Texts> {
  switch (language) {
    case "en":
      return (await import("./en/index.ts")).en;
    case "de":
      return (await import("./de/index.ts")).de;
    case "fr":
      return (await import("./fr/index.ts")).fr;
    case "zh":
      return (await import("./zh/index.ts")).zh;
  }
}
