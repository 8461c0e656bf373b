import { part, type Pt } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { ContourChoice, DrawnContour, DrawnCurve, Drawing } from "./drawing.ts";
import { placingOf } from "./halves.ts";
import { alongAxis } from "./on-drawing.ts";

/** A line drawn by hand may be so much off the axis, as a slope. */
const STRAIGHT = 1e-3;
/** Most positions that keys step through. */
const MOST = 2000;
/** A control keeps three decimals. */
export const rounded = (n: number): number => Math.round(n * 1000) / 1000 + 0;

/** Index of the curve nearest to a point within a distance, mm; null if there is none. Centre lines count last. */
export function nearestCurve(
  curves: readonly DrawnCurve[],
  p: Pt,
  within: number,
  counts: (curve: DrawnCurve) => boolean = () => true,
): number | null {
  let found: number | null = null,
    least = within;
  curves.forEach((curve, i) => {
    const { segment: s } = curve;
    // Most curves are far off, which needs no arcs.
    const reach = s.kind === "arc" ? 2 * part.radiusOf(s) : Math.hypot(s.to.z - s.from.z, s.to.r - s.from.r);
    if (Math.hypot(p.z - s.from.z, p.r - s.from.r) > reach + least || !counts(curve)) return;
    const far = part.distanceTo(s, p);
    if (far <= least) [found, least] = [i, far];
  });
  return found;
}

/** Axis along a straight line; null for other curves and slopes. */
export function axisAlong({ segment: s }: DrawnCurve): Pick<ContourChoice, "axis" | "axisAt"> | null {
  if (s.kind !== "line") return null;
  const dz = Math.abs(s.to.z - s.from.z),
    dr = Math.abs(s.to.r - s.from.r);
  if (dr <= STRAIGHT * dz) return { axis: "x", axisAt: rounded((s.from.r + s.to.r) / 2) };
  return dz <= STRAIGHT * dr ? { axis: "y", axisAt: rounded((s.from.z + s.to.z) / 2) } : null;
}

/** Increasing values without repetition. */
const distinct = (values: readonly number[]): number[] =>
  values
    .map(rounded)
    .sort((a, b) => a - b)
    .filter((v, i, all) => i === 0 || v - (all[i - 1] ?? 0) > SAME)
    .slice(0, MOST);

/** Positions of lines along one direction, increasing: possible axes of rotation. */
export const axisPositions = (drawing: Drawing, axis: ContourChoice["axis"]): number[] =>
  distinct(
    drawing.curves.flatMap((curve) => {
      const on = axisAlong(curve);
      return on?.axis === axis ? [on.axisAt] : [];
    }),
  );

/** Positions of the ends of the chosen piece along the axis, increasing: possible zero points. */
export const zeroPositions = (drawing: Drawing, choice: ContourChoice, contour: DrawnContour): number[] =>
  distinct(
    (contour.pieces[choice.piece]?.curves ?? []).flatMap((i) => {
      const s = drawing.curves[i]?.segment;
      return s ? [alongAxis(choice, s.from), alongAxis(choice, s.to)] : [];
    }),
  );

/** The next position in a direction from the present one; the present one at the end of the list. */
export const nextPosition = (positions: readonly number[], from: number, by: 1 | -1): number =>
  (by > 0 ? positions.find((v) => v > from + SAME) : positions.findLast((v) => v < from - SAME)) ?? from;

/** The nearest of some positions, if it is within a distance, mm; else the position itself. */
export function snapped(positions: readonly number[], to: number, within: number): number {
  const near = positions.reduce((best, v) => (Math.abs(v - to) < Math.abs(best - to) ? v : best), Infinity);
  return Math.abs(near - to) <= within ? near : rounded(to);
}

/** Index of the row whose end is nearest to a place of the drawing; null without rows. Ends are those of the contour. */
export function rowNear(choice: ContourChoice, ends: readonly (Pt | null)[], place: Pt): number | null {
  const p = placingOf(choice)(place);
  let found: number | null = null,
    least = Infinity;
  ends.forEach((end, i) => {
    if (!end) return;
    const far = Math.hypot(end.z - p.z, end.r - p.r);
    if (far < least) [found, least] = [i, far];
  });
  return found;
}
