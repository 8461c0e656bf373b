import type { Language } from "./languages.ts";
import type { ToolCodeTexts } from "./tool-code-text.ts";

/** The texts of the reading of tool codes, fetched with the tool table. */
export async function loadToolWords(language: Language): Promise<ToolCodeTexts> {
  switch (language) {
    case "en":
      return (await import("./en/tool-codes.ts")).toolCodes;
    case "de":
      return (await import("./de/tool-codes.ts")).toolCodes;
    case "fr":
      return (await import("./fr/tool-codes.ts")).toolCodes;
    case "zh":
      return (await import("./zh/tool-codes.ts")).toolCodes;
  }
}
