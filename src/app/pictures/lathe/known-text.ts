import type { KnownOutline, KnownPosition } from "../../../cycles/known-outline.ts";
import type { Texts } from "../../../i18n/index.ts";
import type { Lengths } from "../../../i18n/lengths.ts";

/** A typed position as a drawing writes it: ⌀61.37. */
export const valueText = (lengths: Lengths, { axis, value }: KnownPosition): string =>
  `${axis === "x" ? "⌀" : "Z"}${lengths.number(value)}`;
/** The same with its Q: Q491 ⌀61.37. */
export const positionText = (lengths: Lengths, p: KnownPosition): string => `${p.q} ${valueText(lengths, p)}`;

/** The known data of a contour, in words. */
export function knownText(
  t: Texts["lathe"],
  lengths: Lengths,
  { positions, contour, sketch, whole }: KnownOutline,
): string {
  const said = positions.map((p) => positionText(lengths, p));
  if (contour.length > 0) said.push(whole ? t.known.whole : t.known.elements(contour.length));
  else if (sketch.length > 0) said.push(t.known.sketch);
  return said.length > 0 ? t.known.soFar(said.join(", ")) : t.known.nothing;
}
