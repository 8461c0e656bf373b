import { at, part, type Segment } from "../kernel/geometry/point.ts";
import { boundsOf, grownBounds } from "./bounds.ts";
import { segmentData } from "./path.ts";

/** Free space round the contour, and how thick its line is, mm. */
const AIR = 5;
const LINE = 0.25;

/** A length in mm without more decimals than a control keeps. */
const mm = (n: number) => String(Number(n.toFixed(3)) || 0);

/**
 * Contours as a drawing of their true size: one unit is a millimetre, Z to the right, X up as a radius, arcs as arcs;
 * the zero point of the drawing is that of the workpiece. Null when there is nothing to draw.
 */
export function contourSvg(
  contours: readonly { readonly name: string; readonly segments: readonly Segment[] }[],
): string | null {
  const boxes = contours.flatMap(({ segments }) => segments.map(part.boxOf));
  const bounds = boundsOf(boxes.flatMap((b) => [b.left, b.right].flatMap((z) => [b.low, b.high].map((r) => at(z, r)))));
  if (!bounds) return null;
  const { left, right, low, high } = grownBounds(bounds, AIR),
    [wide, tall] = [mm(right - left), mm(high - low)];
  const paths = contours.map(({ name, segments }) => `  <path id="${name}" d="${segmentData(segments)}"/>`);
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${wide}mm" height="${tall}mm" viewBox="${mm(left)} ${mm(-high)} ${wide} ${tall}">`,
    ` <g transform="scale(1 -1)" fill="none" stroke="#000000" stroke-width="${LINE}" stroke-linejoin="round">`,
    ...paths,
    " </g>",
    "</svg>",
    "",
  ].join("\n");
}
