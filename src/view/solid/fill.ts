import { areaOfRing } from "../../kernel/area/area.ts";
import { at, type Pt, type Ring } from "../../kernel/geometry/point.ts";

/*
 * Triangulation of an area. Holes are joined to the outline round them by a cut, then corners whose triangle contains
 * no other corner are clipped one by one. No corner is added, so that surfaces built on both sides of an outline match.
 */

/** A corner of the remaining outline. */
interface Corner {
  readonly p: Pt;
  /** Place in the list of all points. */
  readonly i: number;
  prev: Corner;
  next: Corner;
}

/** Twice the area of a triangle, mm²: positive when it runs counter-clockwise. */
const turn = (a: Pt, b: Pt, c: Pt) => (b.z - a.z) * (c.r - a.r) - (b.r - a.r) * (c.z - a.z);

function loop(ring: Ring, first: number): Corner {
  let head: Corner | null = null;
  let last: Corner | null = null;
  ring.forEach((p, k) => {
    const corner = { p, i: first + k } as Corner;
    corner.prev = last ?? corner;
    if (last) last.next = corner;
    head ??= corner;
    last = corner;
  });
  const [begin, end] = [head as unknown as Corner, last as unknown as Corner];
  begin.prev = end;
  end.next = begin;
  return begin;
}

function* around(start: Corner): Generator<Corner> {
  let c = start;
  do {
    yield c;
    c = c.next;
  } while (c !== start);
}

/** Whether a point lies in a ring; beside its edge it may fall either way. */
function holds(ring: Ring, p: Pt): boolean {
  let inside = false;
  let a = ring.at(-1);
  for (const b of ring) {
    if (a && a.r > p.r !== b.r > p.r && p.z < a.z + ((p.r - a.r) / (b.r - a.r)) * (b.z - a.z)) inside = !inside;
    a = b;
  }
  return inside;
}

const within = (a: Pt, b: Pt, c: Pt, p: Pt) => turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;

/** Whether the way from a corner to a point begins inside the area. */
const looksInside = ({ prev, p, next }: Corner, to: Pt) =>
  turn(prev.p, p, next.p) > 0
    ? turn(p, next.p, to) >= 0 && turn(prev.p, p, to) >= 0
    : turn(p, next.p, to) >= 0 || turn(prev.p, p, to) >= 0;

/** The corner of an outline visible from a point inside it, straight towards +Z or as near to that as possible. */
function seenFrom(p: Pt, outline: Corner): Corner | null {
  let hit = Infinity;
  let near: Corner | null = null;
  for (const a of around(outline)) {
    const b = a.next;
    if (a.p.r > p.r || b.p.r < p.r || a.p.r === b.p.r) continue;
    const z = a.p.z + ((p.r - a.p.r) / (b.p.r - a.p.r)) * (b.p.z - a.p.z);
    if (z < p.z || z >= hit) continue;
    hit = z;
    near = a.p.z > b.p.z ? a : b;
  }
  if (!near) return null;
  const meets = at(hit, p.r);
  const [low, high] = near.p.r < p.r ? [near.p, meets] : [meets, near.p];
  let best: Corner = near;
  let slope = Infinity;
  for (const c of around(outline)) {
    if (c.p.z < p.z || !within(p, low, high, c.p) || !looksInside(c, p)) continue;
    const steep = Math.abs(c.p.r - p.r) / Math.max(c.p.z - p.z, Number.MIN_VALUE);
    if (steep < slope || (steep === slope && c.p.z < best.p.z)) {
      best = c;
      slope = steep;
    }
  }
  return best;
}

/** Cuts from a corner of the outline to one of a hole and back, so that both are one outline. */
function joinHole(outline: Corner, hole: Corner): void {
  const [back, away] = [{ p: outline.p, i: outline.i } as Corner, { p: hole.p, i: hole.i } as Corner];
  back.next = outline.next;
  outline.next.prev = back;
  away.prev = hole.prev;
  hole.prev.next = away;
  outline.next = hole;
  hole.prev = outline;
  away.next = back;
  back.prev = away;
}

/**
 * Clips ears until nothing is left. An outline that touches itself may have no true ear: then the next convex corner is
 * clipped.
 */
function clipEars(start: Corner, out: number[]): void {
  let count = [...around(start)].length;
  let c = start;
  let waited = 0;
  let strict = true;
  while (count > 2) {
    const { prev, next } = c;
    const area = turn(prev.p, c.p, next.p);
    if (area >= 0 && (!strict || area === 0 || isEar(c))) {
      // A corner on a straight side makes a triangle without area, so that no other body's corner lies on an edge.
      if (prev.i !== next.i) out.push(prev.i, c.i, next.i);
      prev.next = next;
      next.prev = prev;
      count -= 1;
      waited = 0;
      strict = true;
      c = next.next;
      continue;
    }
    c = next;
    waited += 1;
    if (waited <= count) continue;
    if (!strict) return;
    strict = false;
    waited = 0;
  }
}

function isEar({ prev, p, next }: Corner): boolean {
  const [a, b] = [prev.p, next.p];
  const [left, right, low, high] = [
    Math.min(a.z, p.z, b.z),
    Math.max(a.z, p.z, b.z),
    Math.min(a.r, p.r, b.r),
    Math.max(a.r, p.r, b.r),
  ];
  for (let c = next.next; c !== prev; c = c.next) {
    const q = c.p;
    if (q.z < left || q.z > right || q.r < low || q.r > high) continue;
    if (same(q, a) || same(q, p) || same(q, b)) continue;
    if (turn(c.prev.p, q, c.next.p) <= 0 && within(a, p, b, q)) return false;
  }
  return true;
}
const same = (a: Pt, b: Pt) => a.z === b.z && a.r === b.r;

/**
 * Triangles, counter-clockwise, that fill outer rings (counter-clockwise) less holes (clockwise), by their places among
 * all points.
 */
export function trianglesOf(rings: readonly Ring[]): number[] {
  const out: number[] = [];
  let first = 0;
  const all = rings.map((ring) => {
    const begin = first;
    first += ring.length;
    return { ring, begin, area: ring.length > 2 ? areaOfRing(ring) : 0 };
  });
  const outers = all.filter((x) => x.area > 0).sort((a, b) => a.area - b.area);
  const rightmost = (corner: Corner) => [...around(corner)].reduce((most, c) => (c.p.z > most.p.z ? c : most));
  const holes = all
    .filter((x) => x.area < 0)
    .map((x) => {
      const corner = rightmost(loop(x.ring, x.begin));
      const inside = (outer: Ring) => x.ring.filter((p) => holds(outer, p)).length;
      return { corner, of: outers.find(({ ring }) => 2 * inside(ring) > x.ring.length) };
    })
    .sort((a, b) => b.corner.p.z - a.corner.p.z);
  for (const outer of outers) {
    const outline = loop(outer.ring, outer.begin);
    for (const { corner, of } of holes) {
      const seen = of === outer && seenFrom(corner.p, outline);
      if (seen) joinHole(seen, corner);
    }
    clipEars(outline, out);
  }
  return out;
}
