import type { Language } from "./languages.ts";
import type { ToolCodeTexts } from "./tool-code-text.ts";
import type { ToolFileTexts } from "./tool-file-text.ts";

/** Texts that only the tool table needs. */
export interface ToolWords {
  readonly codes: ToolCodeTexts;
  readonly files: ToolFileTexts;
}

/** Both parts of the texts of the tool table, fetched with it. */
export async function loadToolWords(language: Language): Promise<ToolWords> {
  const [{ toolCodes: codes }, { toolFiles: files }] = await partsOf(language);
  return { codes, files };
}

function partsOf(language: Language) {
  switch (language) {
    case "en":
      return Promise.all([import("./en/tool-codes.ts"), import("./en/tool-files.ts")]);
    case "de":
      return Promise.all([import("./de/tool-codes.ts"), import("./de/tool-files.ts")]);
    case "fr":
      return Promise.all([import("./fr/tool-codes.ts"), import("./fr/tool-files.ts")]);
    case "zh":
      return Promise.all([import("./zh/tool-codes.ts"), import("./zh/tool-files.ts")]);
  }
}
