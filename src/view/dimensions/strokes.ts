import type { Place } from "../camera.ts";

/** A number of path data: hundredths of a millimetre on paper, of a pixel on a screen. */
export const onPaperGrid = (v: number): string => String(Math.round(v * 100) / 100 + 0);

/** Path data of straight lines through places. */
export const lineThrough = (places: readonly Place[]): string =>
  `M${places.map(({ x, y }) => `${onPaperGrid(x)} ${onPaperGrid(y)}`).join("L")}`;

/** Path data of an arrowhead whose tip points in a direction of length one; `half`: half of its width. */
export function arrowAt(
  tip: Place,
  way: Place,
  { long, half }: { readonly long: number; readonly half: number },
): string {
  const side = (by: number): Place => ({
    x: tip.x - way.x * long - way.y * by,
    y: tip.y - way.y * long + way.x * by,
  });
  return `${lineThrough([tip, side(half), side(-half)])}Z`;
}
