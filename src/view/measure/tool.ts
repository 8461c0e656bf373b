import type { MeasuredKind, MeasuredPlace } from "../../kernel/plan/measured.ts";
import { part } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { gauged } from "./figure.ts";
import type { Snapping } from "./snap.ts";
import { wallAt } from "./wall.ts";

/**
 * Why a tool measures nothing: the place is none for it, the two have no distance its way, the two edges never meet.
 */
export type PickedNothing = "nothing" | "level" | "parallel";
/** What a place that was picked leads to: a second one is waited for, something is measured, or nothing is. */
export type Picked =
  { readonly waits: MeasuredPlace } | { readonly measured: readonly MeasuredPlace[] } | PickedNothing;

const sameEdge = (a: MeasuredPlace, b: MeasuredPlace): boolean =>
  a.edge !== undefined &&
  a.edge.of === b.edge?.of &&
  a.edge.chain === b.edge.chain &&
  a.edge.element === b.edge.element;

/** How near to the axis a place means the axis, as a share of where the edge lies, and mm. */
const onAxis = ({ edge, spot }: MeasuredPlace): boolean => edge === undefined && spot === "free";

/**
 * A place was picked with a tool of measuring, `first` before it where the tool waits for a second one. Angles: the
 * same edge again, or a place beside all edges, means the angle to the axis.
 */
export function pickedWith(
  kind: MeasuredKind,
  snapping: Snapping,
  place: MeasuredPlace,
  first: MeasuredPlace | null,
): Picked {
  switch (kind) {
    case "diameter":
      if (!snapping.drawing.isTurned && place.edge?.segment.kind !== "arc") return "nothing";
      // A caliper closes on a surface: beside all of them it would measure where the pointer happened to be.
      return !place.edge || (snapping.drawing.isTurned && Math.abs(place.at.r) < SAME)
        ? "nothing"
        : { measured: [place] };
    case "radius":
      return place.edge?.segment.kind === "arc" ? { measured: [place] } : "nothing";
    case "wall": {
      const both = wallAt(snapping, place);
      return both ? { measured: both } : "nothing";
    }
    case "angle":
      if (!first) return place.edge?.segment.kind === "line" ? { waits: place } : "nothing";
      if (onAxis(place) || sameEdge(first, place)) return { measured: [first] };
      return gauged(kind, [first, place], snapping.drawing.isTurned) ? { measured: [first, place] } : "parallel";
    case "length":
    case "depth":
    case "distance": {
      if (!first) return { waits: place };
      if (part.apart(first.at, place.at) < SAME) return "nothing";
      const way = part.difference(place.at, first.at),
        far = { length: way.z, depth: way.r, distance: Infinity }[kind];
      return Math.abs(far) < SAME ? "level" : { measured: [first, place] };
    }
  }
}
