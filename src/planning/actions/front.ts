import { part, type Segment } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { THICKEST } from "../apply-action.ts";
import { perObject } from "../../nc/per-object.ts";
import type { Chain } from "../types.ts";

/** A chain without the faces in front of it, which facing takes. */
export const withoutFront = perObject((chain: Chain): Chain => {
  const { segments, marks } = chain;
  const first = segments.findIndex((s) => Math.abs(s.to.z - s.from.z) > SAME);
  if (first === 0) return chain;
  return first < 0 ? { segments: [], marks: [] } : { segments: segments.slice(first), marks: marks.slice(first) };
});

/**
 * A section without the chamfer or the radius at its front: the wall behind it goes on to there, and finishing takes the
 * edge. A level of roughing for an edge alone moves the others off the wall, so that one pass more goes along it. Null
 * where there is none, or one too thick for a finishing cut.
 */
export function withoutEdge(
  segments: readonly Segment[],
  site: "outside" | "inside" = "outside",
): readonly Segment[] | null {
  const [edge, wall, ...rest] = segments;
  if (wall?.kind !== "line" || !edge || Math.abs(wall.to.z - wall.from.z) < SAME) return null;
  const { from, to } = wall;
  const slope = (to.r - from.r) / (to.z - from.z);
  const corner = part.point(edge.from.z, from.r + slope * (edge.from.z - from.z));
  const height = site === "outside" ? corner.r - edge.from.r : edge.from.r - corner.r;
  if (height < SAME || part.apart(corner, part.nearestOn(edge, corner)) > THICKEST) return null;
  return [part.line(corner, to), ...rest];
}
