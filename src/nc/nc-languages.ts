/** NC text languages of the control; each job stores one. */
export const NC_LANGUAGES = ["en", "de", "fr", "zh"] as const;
export type NcLanguage = (typeof NC_LANGUAGES)[number];
