import type { Pt, Segment } from "./point.ts";
import { ROUND } from "./tolerance.ts";
import { axial, radius } from "./units.ts";

type Arc = Extract<Segment, { kind: "arc" }>;

/** An arc in polar form round its centre, angles in radians; `sweep` is signed, counter-clockwise positive. */
export interface Polar {
  readonly start: number;
  readonly sweep: number;
  readonly startRadius: number;
  readonly endRadius: number;
}

/**
 * Polar form of an arc. One that ends where it starts is a full circle. An end point that misses the circle a little
 * makes a spiral, so that the path still ends where it says.
 */
export function polarOf(s: Arc): Polar {
  const start = Math.atan2(s.from.r - s.centre.r, s.from.z - s.centre.z);
  const end = Math.atan2(s.to.r - s.centre.r, s.to.z - s.centre.z);
  const same = Math.hypot(s.to.z - s.from.z, s.to.r - s.from.r) < ROUND;
  const way = s.turn === "ccw" ? 1 : -1;
  const between = (way * (end - start)) % (2 * Math.PI);
  const positive = between < 0 ? between + 2 * Math.PI : between;
  return {
    start,
    sweep: way * (same ? 2 * Math.PI : positive),
    startRadius: Math.hypot(s.from.z - s.centre.z, s.from.r - s.centre.r),
    endRadius: Math.hypot(s.to.z - s.centre.z, s.to.r - s.centre.r),
  };
}

/** The point of a segment at a fraction 0 … 1 of its way. */
export function pointOn(s: Segment, fraction: number): Pt {
  if (fraction <= 0) return s.from;
  if (fraction >= 1) return s.to;
  if (s.kind === "line")
    return { z: axial(s.from.z + (s.to.z - s.from.z) * fraction), r: radius(s.from.r + (s.to.r - s.from.r) * fraction) };
  return pointRound(s.centre, polarOf(s), fraction);
}

/** The point at a fraction 0 … 1 of the way along an arc in polar form. */
export function pointRound(centre: Pt, p: Polar, fraction: number): Pt {
  const angle = p.start + p.sweep * fraction;
  const size = p.startRadius + (p.endRadius - p.startRadius) * fraction;
  return { z: axial(centre.z + size * Math.cos(angle)), r: radius(centre.r + size * Math.sin(angle)) };
}

/** Chords that an arc of `size` mm and `sweep` radians needs to stay within `chord` mm. Never more than a fine full circle. */
export function chordsOf(size: number, sweep: number, chord: number): number {
  const step = 2 * Math.acos(Math.max(0, 1 - chord / Math.max(size, chord)));
  const count = Math.ceil(Math.abs(sweep) / Math.max(step, 1e-3) - ROUND);
  return Number.isFinite(count) ? Math.max(1, count) : 1;
}

/**
 * Points along a segment, both ends included; an arc becomes chords that stay within `chord` mm of it,
 * whose points lie on it.
 */
export function flattened(s: Segment, chord: number): Pt[] {
  if (s.kind === "line") return [s.from, s.to];
  const p = polarOf(s);
  const count = chordsOf(Math.max(p.startRadius, p.endRadius), p.sweep, chord);
  return Array.from({ length: count + 1 }, (_, i) => (i === 0 ? s.from : i === count ? s.to : pointRound(s.centre, p, i / count)));
}

/** Points along a chain of segments, each joint once. */
export function flattenedChain(chain: readonly Segment[], chord: number): Pt[] {
  const out: Pt[] = [];
  for (const s of chain) {
    const points = flattened(s, chord);
    const last = out[out.length - 1];
    const first = points[0];
    const joined = last && first && Math.hypot(last.z - first.z, last.r - first.r) < ROUND;
    for (const p of joined ? points.slice(1) : points) out.push(p);
  }
  return out;
}
