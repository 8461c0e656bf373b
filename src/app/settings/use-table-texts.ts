import { use } from "react";
import type { TableTexts } from "../../i18n/index.ts";
import type { Language } from "../../i18n/languages.ts";
import { loadTables } from "../../i18n/load-tables.ts";
import { untilHere } from "../parts.ts";
import { useSettings } from "./settings.ts";

/** Texts that are here, and one promise for each language whose texts are on their way. */
const here = new Map<Language, TableTexts>();
const coming = new Map<Language, Promise<TableTexts>>();

/** Puts the texts of a language in place. */
export const provideTableTexts = (language: Language, texts: TableTexts): void => void here.set(language, texts);

function comingTexts(language: Language): Promise<TableTexts> {
  const known = coming.get(language) ?? untilHere(() => loadTables(language)).then((texts) => {
    provideTableTexts(language, texts);
    return texts;
  });
  coming.set(language, known);
  return known;
}

/** What the tables of the device say in the screen language; a component that uses this follows the language switch. */
export function useTableTexts(): TableTexts {
  const language = useSettings((s) => s.language);
  return here.get(language) ?? use(comingTexts(language));
}
