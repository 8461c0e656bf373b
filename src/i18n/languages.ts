import { NC_LANGUAGES, type NcLanguage } from "../nc/nc-languages.ts";

/**
 * The screen languages, one per line: own name, decimal sign, and list separator. The key is the language tag and the
 * folder next to this file with the texts.
 */
export const SCREEN_LANGUAGES = {
  en: { name: "English", decimal: ".", comma: ", " },
  de: { name: "Deutsch", decimal: ",", comma: ", " },
  fr: { name: "Français", decimal: ",", comma: ", " },
  zh: { name: "中文", decimal: ".", comma: "、" },
} as const;
export type Language = keyof typeof SCREEN_LANGUAGES;
export const LANGUAGES = Object.keys(SCREEN_LANGUAGES) as readonly Language[];

/** True for a valid language setting from outside (saved program, browser). */
export const isLanguage = (name: string): name is Language => Object.hasOwn(SCREEN_LANGUAGES, name);

/** The language of NC text for a screen language: English where controls do not have it. */
export const ncLanguageOf = (screen: Language): NcLanguage => NC_LANGUAGES.find((each) => each === screen) ?? "en";

/** The languages of lessons and tasks, in fallback order. */
export const LESSON_LANGUAGES = ["en", "de", "fr", "zh"] as const;
export type LessonLanguage = (typeof LESSON_LANGUAGES)[number];

/** The language of a task written in a screen language: English where tasks do not have it. */
export const lessonLanguageOf = (screen: Language): LessonLanguage =>
  LESSON_LANGUAGES.find((each) => each === screen) ?? "en";
