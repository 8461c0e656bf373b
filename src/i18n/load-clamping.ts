import type { ClampingTexts } from "./en/clamping.ts";
import type { Language } from "./languages.ts";

/** The texts of measuring, fetched when something is clampingd. */
export async function loadClamping(language: Language): Promise<ClampingTexts> {
  switch (language) {
    case "en":
      return (await import("./en/clamping.ts")).clamping;
    case "de":
      return (await import("./de/clamping.ts")).clamping;
    case "fr":
      return (await import("./fr/clamping.ts")).clamping;
    case "zh":
      return (await import("./zh/clamping.ts")).clamping;
  }
}
