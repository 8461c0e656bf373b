import type { AdviceTexts } from "./en/advice.ts";
import type { Language } from "./languages.ts";

/** What advice says, fetched when some is given. */
export async function loadAdvice(language: Language): Promise<AdviceTexts> {
  switch (language) {
    case "en":
      return (await import("./en/advice.ts")).advice;
    case "de":
      return (await import("./de/advice.ts")).advice;
    case "fr":
      return (await import("./fr/advice.ts")).advice;
    case "zh":
      return (await import("./zh/advice.ts")).advice;
  }
}
