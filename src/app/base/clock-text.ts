import type { Language } from "../../i18n/languages.ts";
import { formatFixed } from "../../i18n/number.ts";

const two = (n: number): string => String(n).padStart(2, "0");

/** Local day in the order that sorts and that spreadsheets of any language read: 2026-11-23. */
export const dayText = (day: Date): string =>
  [day.getFullYear(), two(day.getMonth() + 1), two(day.getDate())].join("-");

/** Local time of day: 14:05. */
export const timeText = (day: Date): string => `${two(day.getHours())}:${two(day.getMinutes())}`;

/** Minutes and seconds as on a stop-watch: 1:04.3. */
export function clockText(language: Language, seconds: number): string {
  const tenths = Math.round(seconds * 10),
    minutes = Math.floor(tenths / 600),
    rest = (tenths - minutes * 600) / 10;
  return `${minutes}:${rest < 10 ? "0" : ""}${formatFixed(language, rest, 1)}`;
}
