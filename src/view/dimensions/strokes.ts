import type { Place } from "../camera.ts";

/** A number of path data: hundredths of a millimetre on paper, of a pixel on a screen. */
export const onPaperGrid = (v: number): string => String(Math.round(v * 100) / 100 + 0);

/** Path data of straight lines through places. */
export const lineThrough = (places: readonly Place[]): string =>
  `M${places.map(({ x, y }) => `${onPaperGrid(x)} ${onPaperGrid(y)}`).join("L")}`;

/** Path data of a circle. */
export const circleAt = ({ x, y }: Place, r: number): string =>
  `M${onPaperGrid(x - r)} ${onPaperGrid(y)}a${r} ${r} 0 1 1 ${r + r} 0a${r} ${r} 0 1 1 ${-r - r} 0Z`;

/** An arrowhead: its length, and half of its width. */
interface Head {
  readonly long: number;
  readonly half: number;
}

/** The corners of an arrowhead whose tip points in a direction of any length. */
export function headPlaces(tip: Place, { x, y }: Place, { long, half }: Head): readonly Place[] {
  const length = Math.hypot(x, y) || 1,
    [ux, uy] = [x / length, y / length];
  const side = (by: number): Place => ({ x: tip.x - ux * long - uy * by, y: tip.y - uy * long + ux * by });
  return [tip, side(half), side(-half)];
}

/** Path data of the same. */
export const arrowAt = (tip: Place, way: Place, head: Head): string => `${lineThrough(headPlaces(tip, way, head))}Z`;
