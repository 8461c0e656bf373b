import { flattened, pointOn } from "../kernel/flatten.ts";
import type { Pt, Ring, Segment } from "../kernel/point.ts";
import type { Step } from "../kernel/step.ts";
import { pathOf } from "../kernel/time.ts";
import { CHORD, GRID } from "../kernel/tolerance.ts";
import { axial, radius } from "../kernel/units.ts";

const finite = (p: Pt) => Number.isFinite(p.z) && Number.isFinite(p.r);

/**
 * What a convex outline (counter-clockwise, relative to the tip) covers while the tip goes straight from `from` to `to`:
 * the convex hull of both positions. Edges that look forward stand at the end, the others at the beginning.
 */
export function hullAlong(outline: Ring, from: Pt, to: Pt): Ring {
  const dz = to.z - from.z;
  const dr = to.r - from.r;
  const count = outline.length;
  const before = (i: number) => {
    const p = outline[i] as Pt;
    return { z: axial(from.z + p.z), r: radius(from.r + p.r) };
  };
  const after = (i: number) => {
    const p = outline[i] as Pt;
    return { z: axial(to.z + p.z), r: radius(to.r + p.r) };
  };
  const looksForward = (i: number) => {
    const p = outline[i] as Pt;
    const q = outline[(i + 1) % count] as Pt;
    return dz * (q.r - p.r) - dr * (q.z - p.z) > 0;
  };
  const hull: Pt[] = [];
  let forward = looksForward(count - 1);
  for (let i = 0; i < count; i += 1) {
    const next = looksForward(i);
    hull.push(forward ? after(i) : before(i));
    if (forward !== next) hull.push(next ? after(i) : before(i));
    forward = next;
  }
  return hull;
}

/** The tip's way through a step up to `fraction`, as chords. The chords of a part are those of the whole, so a longer part covers a shorter one. */
export function waypoints(step: Step, fraction: number): Pt[] {
  const path = pathOf(step.from, step.move);
  const points = flattened(path, CHORD);
  if (fraction >= 1) return points;
  const at = Math.max(0, fraction) * (points.length - 1);
  const whole = Math.floor(at);
  const [last, next] = [points[whole] as Pt, points[whole + 1] as Pt];
  return [...points.slice(0, whole + 1), pointOn({ kind: "line", from: last, to: next }, at - whole)];
}

/** The work turns: what is swept on the other side of the axis (r < 0) is swept on this side. There is no stock at r < 0. */
function turned(ring: Ring): Ring[] {
  let [lowest, highest] = [Infinity, -Infinity];
  for (const { r } of ring) {
    if (r < lowest) lowest = r;
    if (r > highest) highest = r;
  }
  if (lowest > -GRID) return [ring];
  const mirrored = ring.map((p): Pt => ({ z: p.z, r: radius(-p.r) })).reverse();
  return highest < GRID ? [mirrored] : [ring, mirrored];
}

/** Convex pieces for each chord between points: one, or two where it crosses the axis. */
function alongPoints(outline: Ring, points: readonly Pt[]): Ring[] {
  if (outline.length < 3 || !points.every(finite)) return [];
  return points.slice(1).flatMap((to, i) => turned(hullAlong(outline, points[i] as Pt, to)));
}

/** Everything that an outline covers in a step up to `fraction`: convex pieces for each chord of its way, on this side of the axis. */
export const sweepOf = (outline: Ring, step: Step, fraction = 1): Ring[] =>
  fraction > 0 ? alongPoints(outline, waypoints(step, fraction)) : [];

/** Everything that an outline covers along a path. */
export const sweepAlong = (outline: Ring, path: Segment): Ring[] => alongPoints(outline, flattened(path, CHORD));
