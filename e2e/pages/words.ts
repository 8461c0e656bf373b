import { LANGUAGES, type Language } from "../../src/i18n/languages.ts";
import type { PartName, PartTexts } from "../../src/i18n/parts.ts";

/** The text parts that page objects use. */
const NAMES = [
  "clamping",
  "compare",
  "course",
  "course-task",
  "course-set",
  "course-teach",
  "device",
  "handed",
  "machine",
  "sheet",
  "tables",
  "tool-codes",
  "tool-files",
  "workplace",
] as const satisfies readonly PartName[];
type Name = (typeof NAMES)[number];

/** Loaded up front: Playwright runs these files without Vite's transformation of the page's loader. */
const read = new Map(
  await Promise.all(
    LANGUAGES.flatMap((language) =>
      NAMES.map(async (name) => {
        const file = (await import(`../../src/i18n/${language}/${name}.ts`)) as Readonly<Record<string, unknown>>;
        return [`${language}/${name}`, Object.values(file)[0]] as const;
      }),
    ),
  ),
);

/** The page texts of a language. */
export const words = <N extends Name>(language: Language, name: N): PartTexts<N> =>
  read.get(`${language}/${name}`) as PartTexts<N>;
