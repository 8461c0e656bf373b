import { at } from "./curve.ts";
import type { Pt, Segment, Turn } from "./point.ts";
import { ROUND } from "./tolerance.ts";

/**
 * A point or a direction of the working plane, mm: X and Y while milling. In turning x is Z and y is the distance from the
 * axis, so that counter-clockwise, left and right mean the same in both.
 */
export interface PlanePoint {
  readonly x: number;
  readonly y: number;
}

/** An element of a contour or path in the working plane. An arc that ends where it starts is a full circle. */
export type PlaneSegment =
  | { readonly kind: "line"; readonly from: PlanePoint; readonly to: PlanePoint }
  | { readonly kind: "arc"; readonly from: PlanePoint; readonly to: PlanePoint; readonly centre: PlanePoint; readonly turn: Turn };

/** Where the tool runs, seen in the direction of the contour: RL, RR, R0. */
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

/** A segment of the working plane for what is written for part space: the same formulas, whatever the axes are called. */
export const partSegment = (s: PlaneSegment): Segment =>
  s.kind === "line"
    ? { kind: "line", from: partPoint(s.from), to: partPoint(s.to) }
    : { kind: "arc", from: partPoint(s.from), to: partPoint(s.to), centre: partPoint(s.centre), turn: s.turn };

export const sum = (a: PlanePoint, b: PlanePoint): PlanePoint => ({ x: a.x + b.x, y: a.y + b.y });
export const difference = (a: PlanePoint, b: PlanePoint): PlanePoint => ({ x: a.x - b.x, y: a.y - b.y });
export const scaled = (a: PlanePoint, k: number): PlanePoint => ({ x: a.x * k, y: a.y * k });
/** The point `k` mm from `p` in a unit direction. */
export const beyond = (p: PlanePoint, way: PlanePoint, k: number): PlanePoint => ({ x: p.x + way.x * k, y: p.y + way.y * k });
export const dot = (a: PlanePoint, b: PlanePoint): number => a.x * b.x + a.y * b.y;
/** Positive when `b` points to the left of `a`. */
export const cross = (a: PlanePoint, b: PlanePoint): number => a.x * b.y - a.y * b.x;
export const sizeOf = (a: PlanePoint): number => Math.hypot(a.x, a.y);
export const apart = (a: PlanePoint, b: PlanePoint): number => Math.hypot(a.x - b.x, a.y - b.y);
/** A quarter turn counter-clockwise: the left of a direction. */
export const leftOf = (a: PlanePoint): PlanePoint => ({ x: -a.y, y: a.x });

/** The same direction with length 1; a direction without length stays. */
export function unit(a: PlanePoint): PlanePoint {
  const size = sizeOf(a);
  return size > 0 ? { x: a.x / size, y: a.y / size } : a;
}

/** A point turned about a centre, degrees, counter-clockwise positive. Whole quarters are exact. */
export function turned(p: PlanePoint, centre: PlanePoint, angle: number): PlanePoint {
  const a = (angle * Math.PI) / 180;
  const quarters = angle / 90;
  const exact = Number.isInteger(quarters) ? [[1, 0], [0, 1], [-1, 0], [0, -1]][((quarters % 4) + 4) % 4] : undefined;
  const [cos, sin] = [exact?.[0] ?? Math.cos(a), exact?.[1] ?? Math.sin(a)];
  const d = difference(p, centre);
  return { x: centre.x + d.x * cos - d.y * sin, y: centre.y + d.x * sin + d.y * cos };
}

/** Direction of travel in a point of a segment, length 1. */
export function directionAt(s: PlaneSegment, p: PlanePoint): PlanePoint {
  if (s.kind === "line") return unit(difference(s.to, s.from));
  const out = leftOf(unit(difference(p, s.centre)));
  return s.turn === "ccw" ? out : { x: -out.x, y: -out.y };
}

/** Unit vector from the contour to the tool for a direction of travel. */
export const towardsTool = (way: PlanePoint, side: Side): PlanePoint =>
  side === "none" ? { x: 0, y: 0 } : side === "left" ? leftOf(way) : scaled(leftOf(way), -1);

/** Angle from the start of an arc to the ray of a point, radians in its turn, 0 … 2π. */
function sweepTo(s: Extract<PlaneSegment, { kind: "arc" }>, p: PlanePoint): number {
  const [a, b] = [difference(s.from, s.centre), difference(p, s.centre)];
  const angle = Math.atan2(cross(a, b), dot(a, b)) * (s.turn === "ccw" ? 1 : -1);
  return angle < -ROUND ? angle + 2 * Math.PI : Math.max(0, angle);
}

/** Centre angle of an arc, radians; a full circle when it ends where it starts. */
export const sweepOf = (s: Extract<PlaneSegment, { kind: "arc" }>): number =>
  apart(s.from, s.to) <= ROUND ? 2 * Math.PI : sweepTo(s, s.to);

/** How far along its segment a point lies, mm; before the beginning of a line negative. */
export const alongSegment = (s: PlaneSegment, p: PlanePoint): number =>
  s.kind === "line" ? dot(difference(p, s.from), unit(difference(s.to, s.from))) : sweepTo(s, p) * apart(s.from, s.centre);

/** Length of a segment, mm. */
export const lengthOfSegment = (s: PlaneSegment): number =>
  s.kind === "line" ? apart(s.from, s.to) : sweepOf(s) * apart(s.from, s.centre);

/** The same segment elsewhere. */
export const movedSegment = (s: PlaneSegment, by: PlanePoint): PlaneSegment =>
  s.kind === "line"
    ? { kind: "line", from: sum(s.from, by), to: sum(s.to, by) }
    : { ...s, from: sum(s.from, by), to: sum(s.to, by), centre: sum(s.centre, by) };

/** The same segment run the other way. */
export const backwards = (s: PlaneSegment): PlaneSegment =>
  s.kind === "line"
    ? { kind: "line", from: s.to, to: s.from }
    : { kind: "arc", from: s.to, to: s.from, centre: s.centre, turn: s.turn === "ccw" ? "cw" : "ccw" };
