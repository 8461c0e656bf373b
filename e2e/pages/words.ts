import type { Language } from "../../src/i18n/languages.ts";
import type { PartTexts } from "../../src/i18n/parts.ts";
import { parts as english } from "./languages/en.ts";

/** The text parts that page objects use. */
type Name = keyof typeof english;
type Parts = { readonly [N in Name]: PartTexts<N> };

/** Each language besides English is a file of its own in the build. */
const LOADERS: Readonly<Record<Exclude<Language, "en">, () => Promise<{ readonly parts: Parts }>>> = {
  de: () => import("./languages/de.ts"),
  fr: () => import("./languages/fr.ts"),
  zh: () => import("./languages/zh.ts"),
};

const loaded = new Map<Language, Parts>([["en", english]]);

/** Loads the texts of a language once. */
export async function loadWords(language: Language): Promise<void> {
  if (language !== "en" && !loaded.has(language)) loaded.set(language, (await LOADERS[language]()).parts);
}

/** The page texts of a language that is loaded. */
export function words<N extends Name>(language: Language, name: N): PartTexts<N> {
  const parts = loaded.get(language);
  if (!parts) throw new Error(`The texts of "${language}" are not loaded: await Turnwise.load("${language}") first.`);
  return parts[name];
}
