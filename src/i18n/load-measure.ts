import type { MeasureTexts } from "./en/measure.ts";
import type { Language } from "./languages.ts";

/** The texts of measuring, fetched when something is measured. */
export async function loadMeasure(language: Language): Promise<MeasureTexts> {
  switch (language) {
    case "en":
      return (await import("./en/measure.ts")).measure;
    case "de":
      return (await import("./de/measure.ts")).measure;
    case "fr":
      return (await import("./fr/measure.ts")).measure;
    case "zh":
      return (await import("./zh/measure.ts")).measure;
  }
}
