import type { SegmentOf } from "../geometry/segments.ts";
import { spaceOf } from "../geometry/space.ts";
import { at, type Pt, type Segment } from "../geometry/point.ts";

/**
 * A point or a direction of the working plane, mm: X and Y while milling. In turning x is Z and y is the distance from
 * the axis, so that counter-clockwise, left and right mean the same in both.
 */
export interface PlanePoint {
  readonly x: number;
  readonly y: number;
}

/** An element of a contour or path in the working plane. */
export type PlaneSegment = SegmentOf<PlanePoint>;

/** Points, lines and arcs of the working plane. */
export const plane = spaceOf<PlanePoint>({ x: (p) => p.x, y: (p) => p.y, point: (x, y) => ({ x, y }) });

/** Side of the tool, seen in the direction of the contour: RL, RR, R0. */
export type Side = "left" | "right" | "none";

/** Turning: part space to the working plane. */
export const planePoint = (p: Pt): PlanePoint => ({ x: p.z, y: p.r });
/** Turning: the working plane to part space. */
export const partPoint = (p: PlanePoint): Pt => at(p.x, p.y);

/** A segment of part space in the working plane. */
export const planeSegment = (s: Segment): PlaneSegment =>
  s.kind === "line"
    ? { kind: "line", from: planePoint(s.from), to: planePoint(s.to) }
    : { kind: "arc", from: planePoint(s.from), to: planePoint(s.to), centre: planePoint(s.centre), turn: s.turn };

/** A segment of the working plane in part space. */
export const partSegment = (s: PlaneSegment): Segment =>
  s.kind === "line"
    ? { kind: "line", from: partPoint(s.from), to: partPoint(s.to) }
    : { kind: "arc", from: partPoint(s.from), to: partPoint(s.to), centre: partPoint(s.centre), turn: s.turn };

/** Unit vector from the contour to the tool for a direction of travel. */
export function towardsTool(way: PlanePoint, side: Side): PlanePoint {
  if (side === "none") return { x: 0, y: 0 };
  return side === "left" ? plane.leftOf(way) : plane.scaled(plane.leftOf(way), -1);
}
