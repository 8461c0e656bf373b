import type { CompareTexts } from "./en/compare.ts";
import type { Language } from "./languages.ts";

/** The texts of a comparison of programs, fetched when one is made. */
export async function loadCompare(language: Language): Promise<CompareTexts> {
  switch (language) {
    case "en":
      return (await import("./en/compare.ts")).compare;
    case "de":
      return (await import("./de/compare.ts")).compare;
    case "fr":
      return (await import("./fr/compare.ts")).compare;
    case "zh":
      return (await import("./zh/compare.ts")).compare;
  }
}
