import type { TableTexts } from "./index.ts";
import type { Language } from "./languages.ts";

/** What the tables of the device say in one language, fetched when one of them is shown. */
export async function loadTables(language: Language): Promise<TableTexts> {
  switch (language) {
    case "en":
      return (await import("./en/tables.ts")).enTables;
    case "de":
      return (await import("./de/tables.ts")).deTables;
    case "fr":
      return (await import("./fr/tables.ts")).frTables;
    case "zh":
      return (await import("./zh/tables.ts")).zhTables;
  }
}
