import type { MeasuredKind, MeasuredPlace } from "../../kernel/plan/measured.ts";
import { part } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { measuredFigure } from "./figure.ts";
import type { Snapping } from "./snap.ts";
import { wallAt } from "./wall.ts";

/**
 * Why a pick measures nothing: the place does not suit the tool, the two have no distance in its direction, or the two
 * edges never meet.
 */
export type PickFailure = "nothing" | "level" | "parallel";
/** The result of a pick: a second place is needed, the measurement is complete, or there is none. */
export type Picked = { readonly waits: MeasuredPlace } | { readonly measured: readonly MeasuredPlace[] } | PickFailure;

const sameEdge = (a: MeasuredPlace, b: MeasuredPlace): boolean =>
  a.edge !== undefined &&
  a.edge.of === b.edge?.of &&
  a.edge.chain === b.edge.chain &&
  a.edge.element === b.edge.element;

/** A place beside all edges stands for the spindle axis. */
const onAxis = ({ edge, spot }: MeasuredPlace): boolean => edge === undefined && spot === "free";

/**
 * The result of picking a place with a measuring tool; `first` is the place picked before it, if the tool needs two.
 * Angles: the same edge again, or a place beside all edges, stands for the angle to the axis.
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
      // A caliper closes on a surface: elsewhere it would measure wherever the pointer happened to be.
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
      return measuredFigure(kind, [first, place], snapping.drawing.isTurned)
        ? { measured: [first, place] }
        : "parallel";
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
