import type { MeasuredEdge, MeasuredKind, MeasuredPlace } from "../../kernel/plan/measured.ts";
import { at, part, type Pt } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { measurableEdges, type Measurable } from "./edges.ts";

/** The kind of geometry that a tool snaps to. */
export type SnapTarget = "point" | "surface" | "arc" | "line" | "wall";
const GRIPS: Readonly<Record<MeasuredKind, SnapTarget>> = {
  diameter: "surface",
  length: "point",
  depth: "point",
  distance: "point",
  radius: "arc",
  angle: "line",
  wall: "wall",
};
/** The kind of geometry that a measuring tool snaps to; without a spindle axis a diameter is that of an arc. */
export const snapTargetOf = (kind: MeasuredKind, { isTurned }: Pick<Measurable, "isTurned">): SnapTarget =>
  kind === "diameter" && !isTurned ? "arc" : GRIPS[kind];

/** Handicap of edges that lie on one another, as a share of the reach: the finished contour wins, then the blank. */
const BEHIND = { contour: 0, blank: 0.06, stock: 0.12 } as const;
/** How much farther than a corner an arc or a line may be, if the tool takes nothing else. */
const FAR = 2.5;

/** On a turned part the same edges are mirrored below the axis. */
const mirror = (p: Pt): Pt => at(p.z, -p.r);
export const halfOf = ({ isTurned }: Pick<Measurable, "isTurned">, p: Pt): 1 | -1 => (isTurned && p.r < 0 ? -1 : 1);
export const onSide = (p: Pt, side: 1 | -1): Pt => (side < 0 ? mirror(p) : p);

const taken = (edge: MeasuredEdge, p: Pt, spot: MeasuredPlace["spot"]): MeasuredPlace => ({ at: p, spot, edge });

interface Found {
  readonly place: () => MeasuredPlace;
  readonly away: number;
}

/** Keeps the nearest of the offered places. */
function nearest(reach: number) {
  let best: Found | null = null;
  return {
    offer(away: number, place: () => MeasuredPlace): void {
      if (away < (best?.away ?? reach)) best = { away, place };
    },
    get: (): MeasuredPlace | null => best?.place() ?? null,
  };
}

/** What lies within reach of a place, the sort that is meant most first: corners, centres, ends of moves, edges. */
function snappedAbove(
  drawing: Measurable,
  edges: readonly MeasuredEdge[],
  p: Pt,
  reach: number,
  grip: SnapTarget,
): MeasuredPlace | null {
  const corner = nearest(reach),
    centre = nearest(reach),
    path = nearest(reach);
  const edge = nearest(grip === "point" || grip === "surface" ? reach : FAR * reach);
  const points = grip === "point" || grip === "surface";
  for (const each of edges) {
    const { segment, of } = each,
      behind = BEHIND[of] * reach;
    if (
      (grip === "arc" && segment.kind !== "arc") ||
      (grip === "line" && segment.kind !== "line") ||
      (grip === "wall" && of !== "stock")
    )
      continue;
    if (points) {
      for (const end of [segment.from, segment.to])
        corner.offer(part.apart(end, p) + behind, () => taken(each, end, "corner"));
      if (segment.kind === "arc" && grip === "point")
        centre.offer(part.apart(segment.centre, p) + behind, () => taken(each, segment.centre, "centre"));
    }
    const on = part.nearestOn(segment, p);
    edge.offer(part.apart(on, p) + behind, () => taken(each, on, "edge"));
  }
  if (grip === "point") {
    for (const end of drawing.path) path.offer(part.apart(end, p), () => ({ at: end, spot: "path" }));
  }
  return corner.get() ?? centre.get() ?? path.get() ?? edge.get();
}

/** The prepared edges of a picture, for many snaps. */
export interface Snapping {
  readonly drawing: Measurable;
  readonly edges: readonly MeasuredEdge[];
}
export const snappingOf = (drawing: Measurable): Snapping => ({ drawing, edges: measurableEdges(drawing) });

/**
 * The place that a measuring tool snaps to, within `reach` mm: a corner before the centre of an arc, that before the
 * end of a move, that before the nearest point of an edge. Without any of them, the place itself.
 */
export function snapAt({ drawing, edges }: Snapping, place: Pt, reach: number, grip: SnapTarget): MeasuredPlace {
  const side = halfOf(drawing, place);
  const found = snappedAbove(drawing, edges, onSide(place, side), reach, grip);
  return found ? { ...found, at: onSide(found.at, side) } : { at: place, spot: "free" };
}

/** The middle of an edge, as a place on it. */
const middleOf = (each: MeasuredEdge): MeasuredPlace => taken(each, part.pointOn(each.segment, 0.5), "edge");

/** The places that a tool snaps to, in the order in which keys step through them; each once. */
export function stopsOf({ drawing, edges }: Snapping, grip: SnapTarget): readonly MeasuredPlace[] {
  const seen = new Set<string>(),
    stops: MeasuredPlace[] = [];
  const add = (stop: MeasuredPlace) => {
    const key = `${Math.round(stop.at.z * 1e3)},${Math.round(stop.at.r * 1e3)}`;
    if (seen.has(key)) return;
    seen.add(key);
    stops.push(stop);
  };
  for (const each of edges) {
    const { segment, of } = each;
    if (grip === "arc" || grip === "line") {
      if (segment.kind === grip) add(middleOf(each));
    } else if (grip === "wall") {
      if (of === "stock") add(middleOf(each));
    } else {
      add(taken(each, segment.from, "corner"));
      if (grip === "surface" && Math.abs(segment.from.z - segment.to.z) > SAME) add(middleOf(each));
      add(taken(each, segment.to, "corner"));
      if (segment.kind === "arc" && grip === "point") add(taken(each, segment.centre, "centre"));
    }
  }
  if (grip === "point") {
    for (const end of drawing.path) add({ at: end, spot: "path" });
  }
  return stops;
}

/** The stop after or before a place; the first or the last one where the place is none. */
export function nextStop(stops: readonly MeasuredPlace[], from: Pt, way: 1 | -1): MeasuredPlace | null {
  const here = stops.findIndex(({ at: p }) => part.apart(p, from) < SAME);
  const next = here < 0 ? (way > 0 ? 0 : stops.length - 1) : (here + way + stops.length) % stops.length;
  return stops[next] ?? null;
}
