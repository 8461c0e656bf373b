import type { MeasuredKind, MeasuredPlace } from "../../kernel/plan/measured.ts";
import { at, part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { ROUND, SAME } from "../../kernel/tolerance.ts";
import { inDegrees, STEP, toDiameter } from "../../kernel/units.ts";
import type { Dimension } from "../dimensions/dimension.ts";
import { onSide, halfOf } from "./snap.ts";

/** A value, mm or degrees, with the dimension that shows it. */
export interface MeasuredFigure {
  readonly value: number;
  readonly figure: Dimension;
}

const lineOf = (place: MeasuredPlace, isTurned: boolean): readonly [Pt, Pt] | null => {
  const segment = place.edge?.segment;
  if (segment?.kind !== "line") return null;
  const side = halfOf({ isTurned }, place.at);
  return [onSide(segment.from, side), onSide(segment.to, side)];
};

const angleBetween = (a: Pt, b: Pt): number => inDegrees(Math.abs(Math.atan2(part.cross(a, b), part.dot(a, b))));

/** The angle of an edge to the axis, 0 … 90°, at its end that lies nearer to the axis. */
function toAxis(place: MeasuredPlace, isTurned: boolean): MeasuredFigure | null {
  const line = lineOf(place, isTurned);
  if (!line) return null;
  const [near, far] = Math.abs(line[0].r) <= Math.abs(line[1].r) ? line : [line[1], line[0]];
  const way = part.unit(part.difference(far, near)),
    axis = at(way.z < 0 ? -1 : 1, 0);
  return {
    value: angleBetween(axis, way),
    // No edge lies along the axis: that leg is only drawn.
    figure: { form: "angle", vertex: near, from: part.sum(near, part.scaled(axis, STEP)), to: far },
  };
}

/** The leg from the intersection of two lines towards a place on one of them. */
function armOf([from, to]: readonly [Pt, Pt], place: Pt, vertex: Pt): { readonly way: Pt; readonly long: number } {
  const end = part.apart(place, vertex) > SAME ? place : part.apart(from, vertex) > part.apart(to, vertex) ? from : to;
  const way = part.unit(part.difference(end, vertex));
  return { way, long: Math.max(0, ...[from, to].map((p) => part.dot(part.difference(p, vertex), way))) };
}

/** Where a leg ends; the shortest where its edge lies behind the intersection. */
const legEnd = (vertex: Pt, { way, long }: ReturnType<typeof armOf>): Pt =>
  part.sum(vertex, part.scaled(way, Math.max(STEP, long)));

/** The angle between two edges, on the sides where they were picked; null for parallel edges. */
function between(first: MeasuredPlace, second: MeasuredPlace, isTurned: boolean): MeasuredFigure | null {
  const [one, two] = [lineOf(first, isTurned), lineOf(second, isTurned)];
  if (!one || !two) return null;
  const [a, b] = [part.unit(part.difference(one[1], one[0])), part.unit(part.difference(two[1], two[0]))];
  const vertex = part.meet({ point: one[0], along: a }, { point: two[0], along: b })[0];
  if (!vertex || Math.abs(part.cross(a, b)) < ROUND) return null;
  const [u, v] = [armOf(one, first.at, vertex), armOf(two, second.at, vertex)];
  return {
    value: angleBetween(u.way, v.way),
    figure: { form: "angle", vertex, from: legEnd(vertex, u), to: legEnd(vertex, v) },
  };
}

const arcOf = (place: MeasuredPlace, isTurned: boolean): { readonly centre: Pt; readonly size: number } | null => {
  const segment: Segment | undefined = place.edge?.segment;
  if (segment?.kind !== "arc") return null;
  return { centre: onSide(segment.centre, halfOf({ isTurned }, place.at)), size: part.radiusOf(segment) };
};

/**
 * The value that a measuring tool reads from its places; null if they give none, such as two parallel edges for an
 * angle. `isTurned`: the second axis counts from a spindle axis.
 */
export function measuredFigure(
  kind: MeasuredKind,
  places: readonly MeasuredPlace[],
  isTurned: boolean,
): MeasuredFigure | null {
  const [first, second] = places;
  if (!first) return null;
  const arc = arcOf(first, isTurned);
  switch (kind) {
    case "diameter":
      if (isTurned) return { value: Math.abs(toDiameter(first.at.r)), figure: { form: kind, at: first.at } };
      return arc && { value: arc.size + arc.size, figure: { form: "circle", at: first.at, centre: arc.centre } };
    case "radius":
      return arc && { value: arc.size, figure: { form: kind, at: first.at, centre: arc.centre } };
    case "angle":
      return second ? between(first, second, isTurned) : toAxis(first, isTurned);
    case "length":
      return second
        ? { value: Math.abs(second.at.z - first.at.z), figure: { form: "z", from: first.at, to: second.at } }
        : null;
    case "depth":
      return second
        ? { value: Math.abs(second.at.r - first.at.r), figure: { form: "r", from: first.at, to: second.at } }
        : null;
    case "distance":
    case "wall":
      return second
        ? { value: part.apart(first.at, second.at), figure: { form: "along", from: first.at, to: second.at } }
        : null;
  }
}
