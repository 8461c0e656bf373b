import type { SolidTexts } from "./en/solid.ts";
import type { Language } from "./languages.ts";

/** The texts of the view in 3D, fetched when it is first shown. */
export async function loadSolid(language: Language): Promise<SolidTexts> {
  switch (language) {
    case "en":
      return (await import("./en/solid.ts")).solid;
    case "de":
      return (await import("./de/solid.ts")).solid;
    case "fr":
      return (await import("./fr/solid.ts")).solid;
    case "zh":
      return (await import("./zh/solid.ts")).solid;
  }
}
