import { centreParts } from "../kernel/cutter/drill.ts";
import { hypotenuse } from "../kernel/geometry/vectors.ts";
import { at, part, type Pt, type Ring, type Segment } from "../kernel/geometry/point.ts";
import type { Step } from "../kernel/time/step.ts";
import { stampsOf, type ThreadMove } from "../kernel/time/thread-turns.ts";
import { pathOf } from "../kernel/time/time.ts";
import { CHORD, GRID } from "../kernel/tolerance.ts";
import { radius } from "../kernel/units.ts";
import { piecesOf, type ConvexPiece } from "./piece.ts";
import { trackAlong } from "./track.ts";

const { flattened, pointOn } = part;

const finite = (p: Pt) => Number.isFinite(p.z) && Number.isFinite(p.r);

/**
 * The convex hull of a convex outline (counter-clockwise, relative to the tip) at both ends of a straight path. Edges
 * that look forward are placed at the end, the others at the start.
 */
export function hullAlong(outline: Ring, from: Pt, to: Pt): Ring {
  const dz = to.z - from.z;
  const dr = to.r - from.r;
  const count = outline.length;
  const before = (i: number) => {
    const p = outline[i] as Pt;
    return at(from.z + p.z, from.r + p.r);
  };
  const after = (i: number) => {
    const p = outline[i] as Pt;
    return at(to.z + p.z, to.r + p.r);
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

/** Longer than any tool, mm. */
const FAR = 10_000;

/** The convex pieces of a convex outline outside the track of another one along a path. */
export function notBehind(outline: Ring, other: Ring, from: Pt, to: Pt): Ring[] {
  const [dz, dr] = [to.z - from.z, to.r - from.r];
  const size = hypotenuse(dz, dr);
  if (!(size > 0) || other.length < 3) return [outline];
  const track = hullAlong(other, at((-dz / size) * FAR, (-dr / size) * FAR), at(0, 0));
  return track.flatMap((p, i) => {
    const q = track[(i + 1) % track.length] as Pt;
    const piece = rightOf(outline, p, q);
    return piece.length > 2 ? [piece] : [];
  });
}

/** The part of a convex ring to the right of a straight line: outside a counter-clockwise outline with that edge. */
export function rightOf(ring: Ring, p: Pt, q: Pt): Ring {
  const out: Pt[] = [];
  const beside = (a: Pt) => (q.r - p.r) * (a.z - p.z) - (q.z - p.z) * (a.r - p.r);
  const least = GRID * hypotenuse(q.z - p.z, q.r - p.r);
  let a = ring[ring.length - 1] as Pt;
  for (const b of ring) {
    const [before, here] = [beside(a) - least, beside(b) - least];
    if (before > 0 !== here > 0) {
      const t = before / (before - here);
      out.push(at(a.z + (b.z - a.z) * t, a.r + (b.r - a.r) * t));
    }
    if (here > 0) out.push(b);
    a = b;
  }
  return out;
}

/**
 * The tip's path through a step up to `fraction`, as chords. Chords of a part are those of the whole, so a longer part
 * covers a shorter one.
 */
export function waypoints(step: Step, fraction: number, chord = CHORD): Pt[] {
  const path = pathOf(step.from, step.move);
  const points = flattened(path, chord);
  if (fraction >= 1) return points;
  const at = Math.max(0, fraction) * (points.length - 1);
  const whole = Math.floor(at);
  const [last, next] = [points[whole] as Pt, points[whole + 1] as Pt];
  return [...points.slice(0, whole + 1), pointOn({ kind: "line", from: last, to: next }, at - whole)];
}

/** The work rotates, so a sweep beyond the axis (r < 0) is mirrored to this side. There is no stock at r < 0. */
export function foldedAtAxis(ring: Ring): Ring[] {
  let [lowest, highest] = [Infinity, -Infinity];
  for (const { r } of ring) {
    if (r < lowest) lowest = r;
    if (r > highest) highest = r;
  }
  if (lowest > -GRID) return [ring];
  const mirrored = ring.map((p): Pt => ({ z: p.z, r: radius(-p.r) })).reverse();
  return highest < GRID ? [mirrored] : [ring, mirrored];
}

const asItIs = (ring: Ring): Ring[] => [ring];

/** Convex pieces for each chord between points: one, or two where it crosses the axis. */
function alongPoints(outline: Ring, points: readonly Pt[], across: (ring: Ring) => Ring[] = foldedAtAxis): Ring[] {
  if (outline.length < 3 || !points.every(finite)) return [];
  return points.slice(1).flatMap((to, i) => across(hullAlong(outline, points[i] as Pt, to)));
}

/**
 * A swept area: convex pieces for contact queries, and rings (by the non-zero rule) with fewer points of the same area
 * for cutting.
 */
export interface Sweep {
  readonly pieces: readonly ConvexPiece[];
  readonly rings: readonly Ring[];
}

function sweptAlong(outline: Ring, points: readonly Pt[], across: (ring: Ring) => Ring[] = foldedAtAxis): Sweep {
  const hulls = alongPoints(outline, points, across);
  return { pieces: piecesOf(hulls), rings: hulls.length < 3 ? hulls : across(trackAlong(outline, points)) };
}

/** The sweep of a thread move in the half plane: the outline's own shape, once per revolution. */
function stamped(outline: Ring, from: Pt, move: ThreadMove, fraction: number): Sweep {
  const places = stampsOf(from, move)
    .filter((s) => s.fraction <= fraction)
    .map((s) => s.at);
  if (outline.length < 3 || !places.every(finite)) return { pieces: [], rings: [] };
  const rings = places.flatMap((place) => foldedAtAxis(outline.map((p) => at(place.z + p.z, place.r + p.r))));
  return { pieces: piecesOf(rings), rings };
}

/** The convex parts of a centre drill in place of its outline, which is not convex. */
function partsOf(outline: Ring, { tool }: Step): readonly Ring[] {
  const parts = centreParts(tool);
  return parts ? parts.map((part) => part.map(({ u, v }) => at(u, v))) : [outline];
}

/** The sweep of an outline in a step up to `fraction`, on this side of the axis. */
export function sweptBy(outline: Ring, step: Step, fraction = 1, chord = CHORD): Sweep {
  if (!(fraction > 0)) return { pieces: [], rings: [] };
  if (step.tool.centre) {
    const sweeps = partsOf(outline, step).map((each) => sweptAlong(each, waypoints(step, fraction, chord)));
    return { pieces: sweeps.flatMap(({ pieces }) => pieces), rings: sweeps.flatMap(({ rings }) => rings) };
  }
  if (step.move.kind === "thread") return stamped(outline, step.from, step.move, fraction);
  return sweptAlong(outline, waypoints(step, fraction, chord));
}

/** The area that an outline covers along a path without rotation: parts beyond the axis are not mirrored. */
export const coveredOn = (outline: Ring, path: Segment, chord = CHORD): Sweep =>
  sweptAlong(outline, flattened(path, chord), asItIs);

/** The sweep of an outline in a step up to `fraction`, as convex pieces. */
export const sweepOf = (outline: Ring, step: Step, fraction = 1): Ring[] =>
  partsOf(outline, step).flatMap((each) => alongPoints(each, waypoints(step, fraction)));

/** The area that an outline covers along a path, as convex pieces. */
export const sweepAlong = (outline: Ring, path: Segment): Ring[] => alongPoints(outline, flattened(path, CHORD));
