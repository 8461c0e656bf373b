import type { Pt, Segment } from "../kernel/geometry/point.ts";
import type { Bounds } from "./camera.ts";

/** The smallest box round all points, or null when there are none. */
export function boundsOf(points: Iterable<Pt>): Bounds | null {
  let left = Infinity,
    right = -Infinity,
    low = Infinity,
    high = -Infinity;
  for (const p of points) {
    left = Math.min(left, p.z);
    right = Math.max(right, p.z);
    low = Math.min(low, p.r);
    high = Math.max(high, p.r);
  }
  return left <= right && low <= high ? { left, right, low, high } : null;
}

/** The box round both; null stands for nothing. */
export function joined(a: Bounds | null, b: Bounds | null): Bounds | null {
  if (!a || !b) return a ?? b;
  return {
    left: Math.min(a.left, b.left),
    right: Math.max(a.right, b.right),
    low: Math.min(a.low, b.low),
    high: Math.max(a.high, b.high),
  };
}

/** What both boxes cover; the second where they have nothing in common. */
export function common(a: Bounds, b: Bounds): Bounds {
  const both = {
    left: Math.max(a.left, b.left),
    right: Math.min(a.right, b.right),
    low: Math.max(a.low, b.low),
    high: Math.min(a.high, b.high),
  };
  return both.left < both.right && both.low < both.high ? both : b;
}

/** The box with its mirror image at the spindle axis. */
export function mirrored(b: Bounds): Bounds {
  const far = Math.max(Math.abs(b.low), Math.abs(b.high));
  return { ...b, low: -far, high: far };
}

/** A box grown by the same length on every side, mm. */
export const grownBounds = (b: Bounds, by: number): Bounds => ({
  left: b.left - by,
  right: b.right + by,
  low: b.low - by,
  high: b.high + by,
});

/** End points of segments, enough to frame a picture of them. */
export function* pointsOf(segments: Iterable<Segment>): Generator<Pt> {
  for (const s of segments) {
    yield s.from;
    yield s.to;
  }
}
