import { at, part, type Pt } from "../../../kernel/geometry/point.ts";
import { JOINED } from "../../../kernel/tolerance.ts";

/** Convex hull, counter-clockwise, with its bounds. */
export interface Hull {
  readonly points: readonly Pt[];
  readonly low: Pt;
  readonly high: Pt;
}

/** Convex hull of points; null when they lie on a line. */
export function hullOf(all: readonly Pt[]): Hull | null {
  const sorted = all.toSorted((a, b) => a.z - b.z || a.r - b.r);
  const chain = (points: readonly Pt[]) => {
    const out: Pt[] = [];
    for (const p of points) {
      for (;;) {
        const [a, b] = [out.at(-2), out.at(-1)];
        if (!a || !b || part.cross(part.difference(b, a), part.difference(p, a)) > 0) break;
        out.pop();
      }
      out.push(p);
    }
    return out.slice(0, -1);
  };
  const points = [...chain(sorted), ...chain(sorted.toReversed())];
  if (points.length < 3) return null;
  let [low, high] = [sorted[0], sorted[0]];
  for (const p of points) {
    low = at(Math.min(low?.z ?? p.z, p.z), Math.min(low?.r ?? p.r, p.r));
    high = at(Math.max(high?.z ?? p.z, p.z), Math.max(high?.r ?? p.r, p.r));
  }
  return low && high ? { points, low, high } : null;
}

/** Whether a point is in a hull, not on its edge. */
export function isInHull({ points, low, high }: Hull, p: Pt): boolean {
  if (p.z <= low.z || p.z >= high.z || p.r <= low.r || p.r >= high.r) return false;
  return points.every((a, i) => {
    const b = points[(i + 1) % points.length] ?? a;
    return part.cross(part.difference(b, a), part.difference(p, a)) > JOINED;
  });
}

/** Whether a point is within loops of points, by the number of edges on one side of it. */
export function isInRing(
  loops: readonly (readonly (readonly [number, number])[])[],
  [x, y]: readonly [number, number],
) {
  let isIn = false;
  for (const loop of loops)
    for (let i = 0, j = loop.length - 1; i < loop.length; j = i, i += 1) {
      const [a, b] = [loop[i], loop[j]];
      if (!a || !b || a[1] > y === b[1] > y) continue;
      if (x < ((b[0] - a[0]) * (y - a[1])) / (b[1] - a[1]) + a[0]) isIn = !isIn;
    }
  return isIn;
}
