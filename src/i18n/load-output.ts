import type { OutputTexts } from "./en/output.ts";
import type { Language } from "./languages.ts";

/** The texts of how programs are written for a machine, fetched when they are set. */
export async function loadOutput(language: Language): Promise<OutputTexts> {
  switch (language) {
    case "en":
      return (await import("./en/output.ts")).output;
    case "de":
      return (await import("./de/output.ts")).output;
    case "fr":
      return (await import("./fr/output.ts")).output;
    case "zh":
      return (await import("./zh/output.ts")).output;
  }
}
