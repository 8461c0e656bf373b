import type { MeasuredEdge, MeasuredPlace } from "../../kernel/plan/measured.ts";
import { part, type Pt } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { onSide, halfOf, type Snapping } from "./snap.ts";

/** Length of a ray, longer than any part, mm. */
const FAR = 1e5;

/** The nearest place where a ray from an edge meets another edge; null if there is none. */
function hit(edges: readonly MeasuredEdge[], from: Pt, way: Pt): MeasuredPlace | null {
  const ray = { kind: "line", from, to: part.beyond(from, way, FAR) } as const;
  let best: { readonly place: MeasuredPlace; readonly away: number } | null = null;
  for (const edge of edges) {
    if (edge.of !== "stock") continue;
    for (const p of part.meetings(ray, edge.segment)) {
      const away = part.along(ray, p);
      if (away < SAME || away > (best?.away ?? FAR) || part.distanceTo(edge.segment, p) > SAME) continue;
      best = { place: { at: p, spot: "edge", edge }, away };
    }
  }
  return best?.place ?? null;
}

/**
 * The wall thickness at a place of the outline, square to it: that place and the opposite one. Outer outlines run
 * counter-clockwise, so that material lies on their left. Null if the material continues to the spindle axis.
 */
export function wallAt(
  { drawing, edges }: Snapping,
  place: MeasuredPlace,
): readonly [MeasuredPlace, MeasuredPlace] | null {
  const { edge } = place;
  if (edge?.of !== "stock") return null;
  const side = halfOf(drawing, place.at),
    from = onSide(place.at, side);
  const across = hit(edges, from, part.leftOf(part.direction(edge.segment, from)));
  return across && [place, { ...across, at: onSide(across.at, side) }];
}
