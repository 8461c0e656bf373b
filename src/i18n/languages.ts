import { NC_LANGUAGES, type NcLanguage } from "../nc/nc-languages.ts";

/**
 * The languages of the screen, a line for each: its own name, its decimal sign, and what stands between the items of a
 * list. The name of the line is the language tag, and the folder beside this file that holds its texts.
 */
export const SCREEN_LANGUAGES = {
  en: { name: "English", decimal: ".", comma: ", " },
  de: { name: "Deutsch", decimal: ",", comma: ", " },
  fr: { name: "Français", decimal: ",", comma: ", " },
  zh: { name: "中文", decimal: ".", comma: "、" },
} as const;
export type Language = keyof typeof SCREEN_LANGUAGES;
export const LANGUAGES = Object.keys(SCREEN_LANGUAGES) as readonly Language[];

/** True for a language setting that may come from outside (saved work, browser). */
export const isLanguage = (name: string): name is Language => Object.hasOwn(SCREEN_LANGUAGES, name);

/** The language of NC text for somebody who reads the screen in a language: English where controls do not have it. */
export const ncLanguageOf = (screen: Language): NcLanguage => NC_LANGUAGES.find((each) => each === screen) ?? "en";

/** The languages that lessons and tasks are told in, in the order in which one stands in for another. */
export const LESSON_LANGUAGES = ["en", "de", "fr", "zh"] as const;
export type LessonLanguage = (typeof LESSON_LANGUAGES)[number];

/**
 * The language in which somebody who reads the screen in a language writes a task: English where tasks do not have it.
 */
export const lessonLanguageOf = (screen: Language): LessonLanguage =>
  LESSON_LANGUAGES.find((each) => each === screen) ?? "en";
