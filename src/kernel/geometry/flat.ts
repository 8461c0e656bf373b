import { opposite, type SegmentOf, type Turn } from "./segments.ts";
import { spaceOf } from "./space.ts";
import { at, type Pt, type Segment } from "./point.ts";

/**
 * Strategy space, mm: `u` runs in the cutting direction, `v` points out of the material. Every strategy is solved once,
 * here; frames map it to outside and inside, towards −Z and +Z, longitudinal and transverse.
 */
export interface Flat {
  readonly u: number;
  readonly v: number;
}

/** A contour or path element in strategy space; turns are as seen with u right and v up. */
export type FlatSegment = SegmentOf<Flat>;

/** Points, lines and arcs of strategy space. */
export const flat = spaceOf<Flat>({ x: (p) => p.u, y: (p) => p.v, point: (u, v) => ({ u, v }) });

/** Orientation of strategy space in the part: an axis swap and two signs, so lengths and angles are preserved. */
export interface Frame {
  /** True when u runs across the spindle axis (transverse cycles). */
  readonly transverse: boolean;
  readonly signU: 1 | -1;
  readonly signV: 1 | -1;
}

/** A position or an offset, part space to strategy space. */
export function toFlat(f: Frame, p: Pt): Flat {
  return f.transverse ? { u: f.signU * p.r, v: f.signV * p.z } : { u: f.signU * p.z, v: f.signV * p.r };
}

/** A position or an offset, strategy space to part space. */
export function toPart(f: Frame, p: Flat): Pt {
  return f.transverse ? at(f.signV * p.v, f.signU * p.u) : at(f.signU * p.u, f.signV * p.v);
}

/** True when the frame mirrors, which reverses the turn of arcs. */
export const mirrors = (f: Frame) => (f.transverse ? -f.signU * f.signV : f.signU * f.signV) < 0;
const turnIn = (f: Frame, turn: Turn) => (mirrors(f) ? opposite(turn) : turn);

/** A contour element, part space to strategy space. */
export function segmentToFlat(f: Frame, s: Segment): FlatSegment {
  const [from, to] = [toFlat(f, s.from), toFlat(f, s.to)];
  return s.kind === "line"
    ? { kind: "line", from, to }
    : { kind: "arc", from, to, centre: toFlat(f, s.centre), turn: turnIn(f, s.turn) };
}

/** A path element, strategy space to part space. */
export function segmentToPart(f: Frame, s: FlatSegment): Segment {
  const [from, to] = [toPart(f, s.from), toPart(f, s.to)];
  return s.kind === "line"
    ? { kind: "line", from, to }
    : { kind: "arc", from, to, centre: toPart(f, s.centre), turn: turnIn(f, s.turn) };
}

/** Outward normal (unit) of a contour element at one of its ends; the material is on the right of the direction. */
export const normalAt = (s: FlatSegment, end: "from" | "to"): Flat => flat.leftOf(flat.direction(s, s[end]));

/** Lowest v of an element. */
export const lowestOf = (s: FlatSegment): number => flat.boxOf(s).low;

/** Highest v of an element. */
export const highestOf = (s: FlatSegment): number => flat.boxOf(s).high;

/** Direction of travel (unit) at one end of an element; that of a line of no length is +u. */
export function tangentAt(s: FlatSegment, end: "from" | "to"): Flat {
  const way = flat.direction(s, s[end]);
  return way.u === 0 && way.v === 0 ? { u: 1, v: 0 } : way;
}
