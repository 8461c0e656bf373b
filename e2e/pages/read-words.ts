import type { Language } from "../../src/i18n/languages.ts";
import type { PartName, PartTexts } from "../../src/i18n/parts.ts";

/** The text parts that page objects use. */
const NAMES = [
  "clamping",
  "compare",
  "course",
  "course-drawing",
  "course-path",
  "course-set",
  "course-task",
  "course-teach",
  "device",
  "handed",
  "machine",
  "plan-comparison",
  "sheet",
  "tables",
  "tool-codes",
  "tool-sheets",
  "tool-files",
  "workplace",
] as const satisfies readonly PartName[];
export type Name = (typeof NAMES)[number];
export type Parts = { readonly [N in Name]: PartTexts<N> };

/** The files of the texts of a language: the build makes one module of them. */
export const filesOf = (language: Language): readonly (readonly [Name, string])[] =>
  NAMES.map((name) => [name, `../../src/i18n/${language}/${name}.ts`]);

/** Reads the texts of a language. The build has a file for each language instead. */
export async function readWords(language: Language): Promise<Parts> {
  // The path is written here, so that a bundler finds the files.
  const read = NAMES.map(async (name) => {
    const file = (await import(`../../src/i18n/${language}/${name}.ts`)) as Readonly<Record<string, unknown>>;
    return [name, Object.values(file)[0]] as const;
  });
  return Object.fromEntries(await Promise.all(read)) as Parts;
}
