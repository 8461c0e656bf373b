import type { Language } from "../../i18n/languages.ts";
import { formatFixed } from "../../i18n/number.ts";

/** Writes minutes and seconds in the words of a language; from an hour on, hours and minutes. */
export type DurationWords = (minutes: number, seconds: string) => string;

/** A time as it is written everywhere: tenths below a minute, then minutes and seconds, then hours and minutes. */
export function durationText(words: DurationWords, language: Language, seconds: number): string {
  const whole = Math.round(seconds);
  return whole < 60
    ? words(0, formatFixed(language, seconds, 1))
    : words(Math.floor(whole / 60), formatFixed(language, whole % 60, 0));
}
