import { hypotenuse } from "../../kernel/geometry/vectors.ts";
import { at, part, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import { GRID } from "../../kernel/tolerance.ts";

/** Tolerance for two grid points to lie on one straight side, mm. */
const ON_SIDE = 3 * GRID;
/** Sample spacing along the free side of a chip, mm, and the greatest number of samples (about). */
const EVERY = 0.25;
const MOST = 64;

/** A straight part of an outline. */
export interface OutlineSide {
  readonly from: Pt;
  readonly to: Pt;
}

const sidesOf = (ring: Ring): OutlineSide[] => ring.map((from, i) => ({ from, to: ring[(i + 1) % ring.length] as Pt }));

/** Returns the indices of the ring's sides that a point lies on. */
function onSides(ring: Ring): (p: Pt) => number[] {
  const lines = sidesOf(ring).map(({ from, to }) => ({
    from,
    way: part.unit(part.difference(to, from)),
    long: part.apart(from, to),
  }));
  return ({ z, r }) => {
    const out: number[] = [];
    for (let i = 0; i < lines.length; i += 1) {
      const { from, way, long } = lines[i] as (typeof lines)[number];
      const [dz, dr] = [z - from.z, r - from.r],
        along = dz * way.z + dr * way.r;
      if (Math.abs(way.z * dr - way.r * dz) < ON_SIDE && along > -ON_SIDE && along < long + ON_SIDE) out.push(i);
    }
    return out;
  };
}

/** The outline of a chip in two parts: polylines along the insert, and the free sides. */
export interface Bounded {
  /** The parts of the insert's outline that bound the chip. */
  readonly contact: readonly (readonly Pt[])[];
  readonly free: readonly OutlineSide[];
}

/** Separates the engaged cutting edge from the free sides of a chip. */
export function boundsOfChip(chip: readonly Ring[], insert: Ring): Bounded {
  const touching = onSides(insert),
    contact: Pt[][] = [],
    free: OutlineSide[] = [];
  for (const ring of chip) {
    const near = ring.map(touching),
      sides = sidesOf(ring);
    const cuts = sides.map((_, i) => (near[i] ?? []).some((side) => near[(i + 1) % ring.length]?.includes(side)));
    const first = cuts.indexOf(false);
    let line: Pt[] = [];
    for (let k = 1; k <= ring.length; k += 1) {
      const i = (first + k) % ring.length,
        { from, to } = sides[i] as OutlineSide;
      if (cuts[i]) line.push(...(line.length === 0 ? [from, to] : [to]));
      else free.push({ from, to });
      if (line.length > 0 && (!cuts[i] || k === ring.length)) {
        contact.push(line);
        line = [];
      }
    }
  }
  return { contact, free };
}

/** The place where a chip is thickest. */
export interface Thickness {
  /** mm. */
  readonly size: number;
  /** A point on the edge, and the point opposite, square to the edge. */
  readonly from: Pt;
  readonly to: Pt;
}

const linesIn = (contact: Bounded["contact"]): OutlineSide[] =>
  contact.flatMap((line) => line.slice(1).map((to, i) => ({ from: line[i] as Pt, to })));

/**
 * The greatest chip thickness: the point on the free side farthest from the engaged edge, measured square to it. Points
 * beyond the ends of the edge do not count. Null without an engaged edge.
 */
export function thickestOf({ contact, free }: Bounded): Thickness | null {
  const edge = linesIn(contact),
    ends = contact.flatMap((line) => [line[0] as Pt, line[line.length - 1] as Pt]);
  const every = Math.max(EVERY, free.reduce((sum, { from, to }) => sum + part.apart(from, to), 0) / MOST);
  let best: Thickness | null = null;
  const look = (p: Pt) => {
    let [size, found] = [Infinity, p];
    for (const { from, to } of edge) {
      const [dz, dr] = [to.z - from.z, to.r - from.r],
        long = dz * dz + dr * dr;
      const on = long > 0 ? Math.min(1, Math.max(0, ((p.z - from.z) * dz + (p.r - from.r) * dr) / long)) : 0;
      const [z, r] = [from.z + dz * on, from.r + dr * on],
        far = hypotenuse(p.z - z, p.r - r);
      if (far < size) [size, found] = [far, at(z, r)];
    }
    if (size > (best?.size ?? 0) && Number.isFinite(size) && ends.every((end) => part.apart(end, found) > ON_SIDE))
      best = { size, from: found, to: p };
  };
  for (const { from, to } of free) {
    const count = Math.max(2, Math.round(part.apart(from, to) / every));
    for (let k = 0; k < count; k += 1) look(part.pointOn({ kind: "line", from, to }, k / count));
  }
  return best;
}

/** How far a chip extends from its edge along a direction, mm: the infeed of a thread. */
export function reachAlong({ contact, free }: Bounded, way: Pt): number {
  let most = 0;
  for (const { from, to } of linesIn(contact)) {
    const long = part.apart(from, to);
    if (long < ON_SIDE) continue;
    const inwards = part.scaled(way, Math.sign(part.cross(part.difference(to, from), way)));
    const far = farAlong(part.pointOn({ kind: "line", from, to }, 0.5), inwards, free);
    if (Number.isFinite(far)) most = Math.max(most, far);
  }
  return most;
}

/** Distance from a point to the first side in a direction, in lengths of `way`; Infinity without a hit. */
function farAlong(p: Pt, way: Pt, sides: readonly OutlineSide[]): number {
  let nearest = Infinity;
  for (const { from, to } of sides) {
    const [dz, dr] = [to.z - from.z, to.r - from.r],
      [ez, er] = [from.z - p.z, from.r - p.r];
    const across = way.z * dr - way.r * dz;
    if (across === 0) continue;
    const far = (ez * dr - er * dz) / across,
      on = (ez * way.r - er * way.z) / across;
    if (on >= 0 && on <= 1 && far > ON_SIDE && far < nearest) nearest = far;
  }
  return nearest;
}

/** Length of the engaged edge, mm. */
export const contactLength = ({ contact }: Bounded): number =>
  linesIn(contact).reduce((sum, { from, to }) => sum + part.apart(from, to), 0);
