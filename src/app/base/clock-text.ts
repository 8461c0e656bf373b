import type { Language } from "../../i18n/languages.ts";
import { formatFixed } from "../../i18n/number.ts";

const two = (n: number): string => String(n).padStart(2, "0");

/** Local day in the order that sorts and that spreadsheets of any language read: 2026-11-23. */
export const dayText = (day: Date): string =>
  [day.getFullYear(), two(day.getMonth() + 1), two(day.getDate())].join("-");

/** Local time of day: 14:05. */
export const timeText = (day: Date): string => `${two(day.getHours())}:${two(day.getMinutes())}`;

/** Writes day and time, ms since 1970, in a language; a dash for a time that is unknown or in no calendar. */
export function momentWriter(language: Language): (at: number) => string {
  const format = new Intl.DateTimeFormat(language, { dateStyle: "medium", timeStyle: "short" });
  return (at) => (at === 0 || Number.isNaN(new Date(at).getTime()) ? "–" : format.format(at));
}

/** Writes minutes and seconds in the words of a language; from an hour on, hours and minutes. */
export type DurationWords = (minutes: number, seconds: string) => string;

/** A time as it is written everywhere: tenths below a minute, then minutes and seconds, then hours and minutes. */
export function durationText(words: DurationWords, language: Language, seconds: number): string {
  const whole = Math.round(seconds);
  return whole < 60
    ? words(0, formatFixed(language, seconds, 1))
    : words(Math.floor(whole / 60), formatFixed(language, whole % 60, 0));
}
