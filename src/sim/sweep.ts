import { centreParts } from "../kernel/cutter/drill.ts";
import { hypotenuse } from "../kernel/geometry/vectors.ts";
import { at, part, type Pt, type Ring, type Segment } from "../kernel/geometry/point.ts";
import type { Step } from "../kernel/time/step.ts";
import { stampsOf, type ThreadMove } from "../kernel/time/thread-turns.ts";
import { pathOf } from "../kernel/time/time.ts";
import { CHORD, GRID } from "../kernel/tolerance.ts";
import { radius } from "../kernel/units.ts";
import { boxOf } from "../kernel/area/box.ts";
import type { Box } from "../kernel/geometry/segments.ts";
import { piecesOf, pushSide, type ConvexPiece } from "./piece.ts";
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

/**
 * The hull of a convex outline along a straight path as a piece: most hulls are only asked for their box and sides, and
 * long runs make millions of them.
 */
class Hull implements ConvexPiece {
  readonly box: Box;
  private corners: Ring | null = null;
  private beside: number[] | null = null;
  constructor(
    private readonly outline: Ring,
    private readonly from: Pt,
    private readonly to: Pt,
  ) {
    const { left, right, low, high } = boxOf(outline);
    this.box = {
      left: left + Math.min(from.z, to.z),
      right: right + Math.max(from.z, to.z),
      low: low + Math.min(from.r, to.r),
      high: high + Math.max(from.r, to.r),
    };
  }
  get ring(): Ring {
    return (this.corners ??= hullAlong(this.outline, this.from, this.to));
  }
  get sides(): readonly number[] {
    return (this.beside ??= sidesAlong(this.outline, this.from, this.to));
  }
}

/** The sides of such a hull, without its corners. */
function sidesAlong(outline: Ring, from: Pt, to: Pt): number[] {
  const [dz, dr] = [to.z - from.z, to.r - from.r];
  const sides: number[] = [];
  const looksForward = (p: Pt, q: Pt) => dz * (q.r - p.r) - dr * (q.z - p.z) > 0;
  let p = outline[outline.length - 1] as Pt,
    was = looksForward(outline[outline.length - 2] as Pt, p);
  for (const q of outline) {
    const forward = looksForward(p, q);
    const [begin, end] = was ? [to, from] : [from, to];
    if (forward !== was) pushSide(sides, begin, end, p.z, p.r);
    const place = forward ? to : from;
    pushSide(sides, p, q, place.z, place.r);
    [p, was] = [q, forward];
  }
  return sides;
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

/** The pieces of an outline along points: one for each chord, or two where it crosses the axis. */
export function piecesAlong(
  outline: Ring,
  points: readonly Pt[],
  across: (ring: Ring) => Ring[] = foldedAtAxis,
): readonly ConvexPiece[] {
  if (outline.length < 3 || !points.every(finite)) return [];
  const pieces: ConvexPiece[] = [];
  for (let i = 1; i < points.length; i += 1) {
    const hull = new Hull(outline, points[i - 1] as Pt, points[i] as Pt);
    if (hull.box.low > -GRID) pieces.push(hull);
    else pieces.push(...piecesOf(across(hull.ring)));
  }
  return pieces;
}

/** The way of a sweep: an outline along points. */
export interface Way {
  readonly outline: Ring;
  readonly points: readonly Pt[];
  readonly across: (ring: Ring) => Ring[];
}

/**
 * A swept area: convex pieces for contact queries, and rings (by the non-zero rule) with fewer points of the same area
 * for cutting.
 */
export interface Sweep {
  readonly pieces: readonly ConvexPiece[];
  readonly rings: readonly Ring[];
  /** Absent where the area is more than one outline along one way. */
  readonly way?: Way;
}

/** A sweep along a way, whose rings are made where somebody asks for them. */
class SweptWay implements Sweep {
  readonly pieces: readonly ConvexPiece[];
  private made: readonly Ring[] | null = null;
  constructor(readonly way: Way) {
    this.pieces = piecesAlong(way.outline, way.points, way.across);
  }
  get rings(): readonly Ring[] {
    return (this.made ??= this.pieces.length < 3 ? this.pieces.map(({ ring }) => ring) : ringsAlong(this.way));
  }
}

const sweptAlong = (outline: Ring, points: readonly Pt[], across: (ring: Ring) => Ring[] = foldedAtAxis): Sweep =>
  new SweptWay({ outline, points, across });

/** The rings of a way. */
export const ringsAlong = ({ outline, points, across }: Way): readonly Ring[] => across(trackAlong(outline, points));

/** No chord along Z: the polygon engine loses areas of a way that covers its own level edges. */
const isSloped = ({ points }: Way): boolean =>
  points.every((p, i) => i === 0 || Math.abs(p.r - (points[i - 1] as Pt).r) > GRID);

const isSame = (p: Pt | undefined, q: Pt | undefined): boolean => p?.z === q?.z && p?.r === q?.r;
/** A run that goes on from a kept state has outlines of its own. */
const isSameOutline = (a: Ring, b: Ring): boolean =>
  a === b || (a.length === b.length && a.every((p, i) => isSame(p, b[i])));

/** Both ways as one, where the second goes on from the end of the first; else null. */
export function wayOn(first: Way, second: Way): Way | null {
  const goesOn =
    first.across === second.across &&
    isSame(first.points.at(-1), second.points[0]) &&
    isSameOutline(first.outline, second.outline);
  return goesOn && isSloped(first) && isSloped(second)
    ? { ...first, points: [...first.points, ...second.points.slice(1)] }
    : null;
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
