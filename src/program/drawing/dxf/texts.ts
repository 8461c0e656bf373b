import type { V3 } from "../space.ts";
import { wordAt, realAt, type DxfRecord } from "./document.ts";
import { normalOf, pointAt } from "./entities.ts";
import { objectPlacing, placed, UNPLACED } from "../space.ts";

/** Longest text that is shown, characters. */
const LONGEST = 200;

/** Text without the codes of its format: %%c is ⌀, \P a line end, {\f…;} a font, \U+00B0 a character. */
export function plainText(raw: string): string {
  return raw
    .slice(0, 20 * LONGEST)
    .replace(/\\U\+([0-9A-F]{4})/gi, (_, hex: string) => String.fromCharCode(parseInt(hex, 16)))
    .replace(/%%c/gi, "⌀")
    .replace(/%%d/gi, "°")
    .replace(/%%p/gi, "±")
    .replace(/%%[uok]/gi, "")
    .replace(/\\[Pp~]/g, " ")
    .replace(/\\S([^;^#/\\]*)[\^#/]([^;\\]*);/g, (_, above: string, below: string) => ` ${above}/${below.trimStart()} `)
    .replace(/\\[ACcFfHhQTWp][^;\\]*;/g, "")
    .replace(/\\[LlOoKk]/g, "")
    .replace(/[{}]/g, "")
    .replace(/\\\\/g, "\\")
    .replace(/\s+/g, " ")
    .trim()
    .slice(0, LONGEST);
}

/** The measure of a dimension as it shows it: its own text, with `<>` for the measure. */
function dimensionText(r: DxfRecord): string {
  const measure = realAt(r, 42),
    shown = measure === null ? "" : String(Number(measure.toFixed(3))),
    typed = wordAt(r, 1);
  return plainText(typed === "" ? shown : typed.replaceAll("<>", shown));
}

/** Text of an entity and its place; null for an empty one, undefined for an entity that is no text. */
export function hintOf(r: DxfRecord): { readonly text: string; readonly at: V3 } | null | undefined {
  const show = (text: string, code: number) => {
    const at = pointAt(r, code) ?? pointAt(r, 10);
    if (text === "" || !at) return null;
    return { text, at: r.type === "TEXT" ? placed(objectPlacing(normalOf(r)) ?? UNPLACED, at) : at };
  };
  switch (r.type) {
    case "TEXT":
    case "TOLERANCE":
      return show(plainText(wordAt(r, 1)), 10);
    case "MTEXT":
      return show(plainText(r.tags.flatMap((t) => (t.code === 3 || t.code === 1 ? [t.text] : [])).join("")), 10);
    case "MULTILEADER":
      return show(plainText(wordAt(r, 304)), 10);
    case "DIMENSION":
    case "ARC_DIMENSION":
    case "LARGE_RADIAL_DIMENSION":
      return show(dimensionText(r), 11);
    case "LEADER":
    case "HATCH":
      return null;
    default:
      return undefined;
  }
}
