/** The languages that a control is set to for its NC text; a job keeps one of them. */
export const NC_LANGUAGES = ["en", "de", "fr", "zh"] as const;
export type NcLanguage = (typeof NC_LANGUAGES)[number];
