import type { Pt, Segment, Turn } from "./point.ts";
import { axial, radius } from "./units.ts";

/**
 * Strategy space, mm: `u` runs in the cutting direction, `v` points out of the material towards the open side. Every
 * strategy is solved here once; frames turn it to outside and inside, towards −Z and +Z, longitudinal and transverse.
 */
export interface Flat {
  readonly u: number;
  readonly v: number;
}

/** A contour or path element in strategy space; `ccw` as seen with u right and v up. */
export type FlatSegment =
  | { readonly kind: "line"; readonly from: Flat; readonly to: Flat }
  | { readonly kind: "arc"; readonly from: Flat; readonly to: Flat; readonly centre: Flat; readonly ccw: boolean };

/** How strategy space lies in the part: an axis swap and two signs, so lengths and angles keep. */
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
  return f.transverse
    ? { z: axial(f.signV * p.v), r: radius(f.signU * p.u) }
    : { z: axial(f.signU * p.u), r: radius(f.signV * p.v) };
}

/** True when the frame mirrors: arcs then change their turn. */
export const mirrors = (f: Frame) => (f.transverse ? -f.signU * f.signV : f.signU * f.signV) < 0;

/** A contour element, part space to strategy space. */
export function segmentToFlat(f: Frame, s: Segment): FlatSegment {
  const from = toFlat(f, s.from);
  const to = toFlat(f, s.to);
  return s.kind === "line"
    ? { kind: "line", from, to }
    : { kind: "arc", from, to, centre: toFlat(f, s.centre), ccw: (s.turn === "ccw") !== mirrors(f) };
}

/** A path element, strategy space to part space. */
export function segmentToPart(f: Frame, s: FlatSegment): Segment {
  const from = toPart(f, s.from);
  const to = toPart(f, s.to);
  if (s.kind === "line") return { kind: "line", from, to };
  const turn: Turn = s.ccw !== mirrors(f) ? "ccw" : "cw";
  return { kind: "arc", from, to, centre: toPart(f, s.centre), turn };
}

/** The same element run the other way. */
export function reversed(s: FlatSegment): FlatSegment {
  return s.kind === "line"
    ? { kind: "line", from: s.to, to: s.from }
    : { kind: "arc", from: s.to, to: s.from, centre: s.centre, ccw: !s.ccw };
}

/** The same element moved by (du, dv). */
export function shifted(s: FlatSegment, du: number, dv: number): FlatSegment {
  const move = (p: Flat): Flat => ({ u: p.u + du, v: p.v + dv });
  return s.kind === "line"
    ? { kind: "line", from: move(s.from), to: move(s.to) }
    : { kind: "arc", from: move(s.from), to: move(s.to), centre: move(s.centre), ccw: s.ccw };
}

export const distance = (a: Flat, b: Flat) => Math.hypot(a.u - b.u, a.v - b.v);

/** Outward normal (unit) of a contour element at one of its ends; the material lies to the right of the direction. */
export function normalAt(s: FlatSegment, end: "from" | "to"): Flat {
  if (s.kind === "line") {
    const l = distance(s.from, s.to) || 1;
    return { u: -(s.to.v - s.from.v) / l, v: (s.to.u - s.from.u) / l };
  }
  const p = s[end];
  const l = distance(p, s.centre) || 1;
  const k = s.ccw ? -1 / l : 1 / l;
  return { u: (p.u - s.centre.u) * k, v: (p.v - s.centre.v) * k };
}

/** Direction of travel (unit) at one end of an element; that of a line of no length is +u. */
export function tangentAt(s: FlatSegment, end: "from" | "to"): Flat {
  const n = normalAt(s, end);
  return n.u === 0 && n.v === 0 ? { u: 1, v: 0 } : { u: n.v, v: -n.u };
}

/** Distance from a point to an element, mm. */
export function distanceTo(s: FlatSegment, p: Flat): number {
  const ends = Math.min(distance(p, s.from), distance(p, s.to));
  if (s.kind === "line") {
    const [du, dv] = [s.to.u - s.from.u, s.to.v - s.from.v];
    const k = ((p.u - s.from.u) * du + (p.v - s.from.v) * dv) / (du * du + dv * dv || 1);
    return k <= 0 || k >= 1 ? ends : Math.hypot(p.u - s.from.u - k * du, p.v - s.from.v - k * dv);
  }
  const way = s.ccw ? 1 : -1;
  const angle = (q: Flat) => Math.atan2(q.v - s.centre.v, q.u - s.centre.u);
  const turn = (a: number) => ((a % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI);
  const sweep = turn(way * (angle(s.to) - angle(s.from))) || 2 * Math.PI;
  const beside = turn(way * (angle(p) - angle(s.from))) <= sweep;
  return beside ? Math.min(ends, Math.abs(distance(p, s.centre) - distance(s.from, s.centre))) : ends;
}

/** Lowest v of an element: of a valley arc that passes its bottom, the bottom. */
export function lowestOf(s: FlatSegment): number {
  const ends = Math.min(s.from.v, s.to.v);
  if (s.kind === "line") return ends;
  const r = distance(s.from, s.centre);
  const way = s.ccw ? 1 : -1;
  const angle = (p: Flat) => Math.atan2(p.v - s.centre.v, p.u - s.centre.u);
  const turn = (a: number) => ((a % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI);
  const sweep = turn(way * (angle(s.to) - angle(s.from))) || 2 * Math.PI;
  return turn(way * (-Math.PI / 2 - angle(s.from))) <= sweep ? Math.min(ends, s.centre.v - r) : ends;
}
