import type { Language } from "../../i18n/languages.ts";
import { formatFixed } from "../../i18n/number.ts";

/** Minutes and seconds as on a stop-watch: 1:04.3. */
export function clockText(language: Language, seconds: number): string {
  const tenths = Math.round(seconds * 10),
    minutes = Math.floor(tenths / 600),
    rest = (tenths - minutes * 600) / 10;
  return `${minutes}:${rest < 10 ? "0" : ""}${formatFixed(language, rest, 1)}`;
}
