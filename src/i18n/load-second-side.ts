import type { SecondSideTexts } from "./en/second-side.ts";
import type { Language } from "./languages.ts";

/** The texts of the next clamping, fetched when a part is turned round. */
export async function loadSecondSide(language: Language): Promise<SecondSideTexts> {
  switch (language) {
    case "en":
      return (await import("./en/second-side.ts")).secondSide;
    case "de":
      return (await import("./de/second-side.ts")).secondSide;
    case "fr":
      return (await import("./fr/second-side.ts")).secondSide;
    case "zh":
      return (await import("./zh/second-side.ts")).secondSide;
  }
}
