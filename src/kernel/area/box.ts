import type { Box } from "../geometry/segments.ts";
import { hypotenuse } from "../geometry/vectors.ts";
import type { Pt, Ring } from "../geometry/point.ts";
import { axial, radius } from "../units.ts";

/** The smallest box around several rings. */
export function boxAround(rings: readonly Ring[]): Box {
  let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const ring of rings)
    for (const p of ring) {
      if (p.z < left) left = p.z;
      if (p.z > right) right = p.z;
      if (p.r < low) low = p.r;
      if (p.r > high) high = p.r;
    }
  return { left, right, low, high };
}

/** The smallest box around a ring. */
export const boxOf = (ring: Ring): Box => boxAround([ring]);

/** Points per chunk. A ring with more points than that is divided into chunks, each with its own box. */
const CHUNK = 32;

/** The boxes of a ring and of its chunks. */
interface Chunks {
  readonly box: Box;
  readonly parts: readonly Box[];
}

/** Cached, because large rings are read many times: a stock with every move. */
const chunked = new WeakMap<Ring, Chunks>();

function chunksOf(ring: Ring): Chunks {
  const known = chunked.get(ring);
  if (known) return known;
  const parts = Array.from({ length: Math.ceil(ring.length / CHUNK) }, (_, i) =>
    boxOf(ring.slice(i * CHUNK, (i + 1) * CHUNK)),
  );
  const made = {
    parts,
    box: {
      left: Math.min(...parts.map((part) => part.left)),
      right: Math.max(...parts.map((part) => part.right)),
      low: Math.min(...parts.map((part) => part.low)),
      high: Math.max(...parts.map((part) => part.high)),
    },
  };
  chunked.set(ring, made);
  return made;
}

/**
 * Drops points that clipping to the box would remove anyway: those in chunks that lie beyond one side of the box, in
 * the order of the sides. The clipped ring is the same to the last bit, with the same order of points.
 */
function nearBox(ring: Ring, parts: readonly Box[], box: Box): Ring {
  const out: Pt[] = [];
  parts.forEach(({ left, right, low, high }, i) => {
    const first = i * CHUNK,
      last = Math.min(ring.length, first + CHUNK) - 1;
    const beside = right < box.left || left > box.right;
    const over = left >= box.left && right <= box.right && (high < box.low || low > box.high);
    if (beside || over) out.push(ring[first] as Pt, ring[last] as Pt);
    else for (let k = first; k <= last; k += 1) out.push(ring[k] as Pt);
  });
  return out;
}

/** Margin of the box that an area is cut to before it is combined with a ring, mm. */
const MARGIN = 0.01;

/**
 * The box that an area may be cut to before it is combined with rings: the sides of the cut then lie beyond the rings.
 * Where they coincided with the rings, the polygon engine reported a common area of 0.5 mm² that did not exist.
 */
export function boxBeyond(rings: readonly Ring[]): Box {
  const { left, right, low, high } = boxAround(rings);
  return { left: left - MARGIN, right: right + MARGIN, low: low - MARGIN, high: high + MARGIN };
}

/** Distance of two boxes, mm; 0 when they overlap. */
export const gapBetween = (a: Box, b: Box): number =>
  hypotenuse(Math.max(0, a.left - b.right, b.left - a.right), Math.max(0, a.low - b.high, b.low - a.high));

/**
 * The part of an area in a box, for further boolean operations or for measuring: outlines may run along the sides of
 * the box more than once, which the non-zero rule of the polygon engine accepts and a signed area does not count. Much
 * faster than a true intersection. The engine's own clip to a rectangle loses a corner where a vertex lies on a side of
 * it, which the law test of this function finds.
 */
export function inBox(area: readonly Ring[], box: Box): Ring[] {
  const out: Ring[] = [];
  for (const ring of area) {
    const chunks = ring.length > CHUNK ? chunksOf(ring) : null,
      own = chunks?.box ?? boxOf(ring);
    if (own.left >= box.right || own.right <= box.left || own.low >= box.high || own.high <= box.low) continue;
    const isInside = own.left >= box.left && own.right <= box.right && own.low >= box.low && own.high <= box.high;
    let cut: Ring = chunks && !isInside ? nearBox(ring, chunks.parts, box) : ring;
    if (own.left < box.left) cut = side(cut, "z", box.left, 1);
    if (own.right > box.right) cut = side(cut, "z", box.right, -1);
    if (own.low < box.low) cut = side(cut, "r", box.low, 1);
    if (own.high > box.high) cut = side(cut, "r", box.high, -1);
    if (cut.length > 2) out.push(cut);
  }
  return out;
}

/** The points of a ring on one side of a straight line across `axis`, with the crossings (Sutherland and Hodgman). */
function side(ring: Ring, axis: "z" | "r", limit: number, sign: 1 | -1): Ring {
  const out: Pt[] = [];
  let a = ring[ring.length - 1];
  for (const b of ring) {
    if (a) {
      const [from, to] = [(a[axis] - limit) * sign, (b[axis] - limit) * sign];
      if (from >= 0 !== to >= 0) {
        const t = from / (from - to);
        out.push({
          z: axial(axis === "z" ? limit : a.z + (b.z - a.z) * t),
          r: radius(axis === "r" ? limit : a.r + (b.r - a.r) * t),
        });
      }
      if (to >= 0) out.push(b);
    }
    a = b;
  }
  return out;
}

/** A block of material whose sides run along the axes, mm: left to right in X, low to high in Y, bottom to top in Z. */
export interface Cuboid extends Box {
  readonly bottom: number;
  readonly top: number;
}
