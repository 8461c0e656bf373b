import { boxAround } from "../../kernel/area/box.ts";
import { part, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { roundedUpTo } from "../../kernel/units.ts";
import type { PlanRequest } from "../types.ts";
import type { Piece } from "./outside-work.ts";

/** Share of the band along its contour that the stock of a casting or a forging fills at least. */
const FILLED = 0.5;
/** Grid of an allowance, mm. */
const GRID = 0.1;

/** Whether a blank has other radii than those of a bar or a tube. */
export function isShaped(blank: readonly Ring[]): boolean {
  const { low, high } = boxAround(blank);
  return blank.flat().some(({ r }) => r > low + SAME && r < high - SAME);
}

/**
 * Allowance of a piece that follows its contour as a casting or a forging does, square to the contour, mm; 0 where it
 * does not: the passes along the contour would cut air beside the highest place.
 */
export function allowanceAlong(
  { rings, area }: Pick<Piece, "rings" | "area">,
  contour: readonly Segment[],
  { blank }: Pick<PlanRequest, "blank">,
): number {
  if (!isShaped(blank)) return 0;
  const distanceOf = (p: Pt) => Math.min(...contour.map((s) => part.apart(p, part.nearestOn(s, p))));
  const most = Math.max(0, ...rings.flat().map(distanceOf));
  const along = contour.reduce((sum, s) => sum + part.lengthOf(s), 0);
  return area > FILLED * most * along ? roundedUpTo(GRID, most) : 0;
}
