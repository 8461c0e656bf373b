import type { Given } from "../../cycles/define.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { coarsened } from "../../kernel/area/clip.ts";
import { part, type Segment } from "../../kernel/geometry/point.ts";

/** A contour with more elements is simplified: planning it exactly takes too long for a help picture. */
const MANY = 150;
/** Detail too fine for a help picture, as a share of the contour's size. */
const FINE = 1 / 1200;

/** A contour for a help picture; one with very many elements is replaced by straight lines that look the same there. */
export function coarseContour(contour: Given["contour"]): Given["contour"] {
  if (!contour || contour.length <= MANY) return contour;
  const { left, right, low, high } = boxAround([contour.flatMap((s) => [s.from, s.to])]);
  const fine = FINE * Math.max(right - left, high - low),
    points = coarsened(part.flattenedChain(contour, fine), fine);
  return points.slice(1).map((to, i): Segment => part.line(points[i] ?? to, to));
}
