import { LANGUAGES, type Language } from "../../src/i18n/languages.ts";
import type { PartName, PartTexts } from "../../src/i18n/parts.ts";

/** The parts of the texts that page objects speak in. */
const NAMES = [
  "clamping",
  "compare",
  "course",
  "course-task",
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

/**
 * All of them, read beforehand: Playwright runs these files as they are, without what Vite makes of the page's own
 * loader.
 */
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

/** What the page says in a language. */
export const words = <N extends Name>(language: Language, name: N): PartTexts<N> =>
  read.get(`${language}/${name}`) as PartTexts<N>;
