/** Languages of the screen. */
export const LANGUAGES = ["en", "de", "fr", "zh"] as const;
export type Language = (typeof LANGUAGES)[number];

/** What each language calls itself, for the language switch. */
export const LANGUAGE_NAMES: Readonly<Record<Language, string>> = {
  en: "English",
  de: "Deutsch",
  fr: "Français",
  zh: "中文",
};

/** Languages that NC text has words for. A control set to Chinese prints English ones (printed on a TNC7 page). */
export const NC_LANGUAGES = ["en", "de", "fr"] as const;
export type NcLanguage = (typeof NC_LANGUAGES)[number];

/** The words that NC text of this language setting really uses. */
export const ncLanguage = (language: Language): NcLanguage => (language === "zh" ? "en" : language);

/** True for a language setting that may come from outside (saved work, browser). */
export const isLanguage = (name: string): name is Language => (LANGUAGES as readonly string[]).includes(name);
