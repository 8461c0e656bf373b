import type { Pt, Ring } from "../kernel/geometry/point.ts";
import type { ConvexPiece } from "./piece.ts";

/** The edges of an area in columns along z, for a quick test whether a convex piece meets the area. */
export interface Edges {
  /** False when the piece surely has no area in common with this one. */
  meets(piece: ConvexPiece): boolean;
}

/** Target number of edges per column, and the most columns worth storing. */
const PER_COLUMN = 4;
const MOST_COLUMNS = 1024;

/** Builds the edge columns of an area. Cost grows with the number of its points only. */
export function sidesOf(area: readonly Ring[]): Edges {
  const total = area.reduce((sum, ring) => sum + ring.length, 0);
  const [z0, r0, z1, r1] = Array.from({ length: 4 }, () => new Float64Array(total)) as [
    Float64Array,
    Float64Array,
    Float64Array,
    Float64Array,
  ];
  let count = 0;
  let [left, right] = [Infinity, -Infinity];
  for (const ring of area) {
    let p = ring[ring.length - 1];
    for (const q of ring) {
      if (p) {
        z0[count] = p.z;
        r0[count] = p.r;
        z1[count] = q.z;
        r1[count] = q.r;
        count += 1;
        left = Math.min(left, q.z);
        right = Math.max(right, q.z);
      }
      p = q;
    }
  }
  const columns = Math.max(1, Math.min(MOST_COLUMNS, Math.floor(count / PER_COLUMN)));
  const perMm = right > left ? columns / (right - left) : 0;
  const columnOf = (z: number) => Math.max(0, Math.min(columns - 1, Math.floor((z - left) * perMm)));
  /** The edges of column c are listed from begins[c] to begins[c + 1]; they lie between low[c] and high[c]. */
  const begins = new Int32Array(columns + 2);
  const [low, high] = [new Float64Array(columns).fill(Infinity), new Float64Array(columns).fill(-Infinity)];
  const firsts = new Int32Array(count);
  const lasts = new Int32Array(count);
  for (let e = 0; e < count; e += 1) {
    const [az, ar, bz, br] = [z0[e] as number, r0[e] as number, z1[e] as number, r1[e] as number];
    const [first, last] = [columnOf(Math.min(az, bz)), columnOf(Math.max(az, bz))];
    firsts[e] = first;
    lasts[e] = last;
    for (let c = first; c <= last; c += 1) {
      begins[c + 2] = (begins[c + 2] as number) + 1;
      low[c] = Math.min(low[c] as number, ar, br);
      high[c] = Math.max(high[c] as number, ar, br);
    }
  }
  for (let c = 2; c < begins.length; c += 1) begins[c] = (begins[c] as number) + (begins[c - 1] as number);
  const list = new Int32Array(begins[columns + 1] as number);
  for (let e = 0; e < count; e += 1)
    for (let c = firsts[e] as number; c <= (lasts[e] as number); c += 1) {
      const next = begins[c + 1] as number;
      list[next] = e;
      begins[c + 1] = next + 1;
    }
  const seen = new Int32Array(count).fill(-1);
  let question = 0;

  /** Whether an edge runs through the inside of a piece: clips it at each side in turn. */
  function enters(e: number, { box, sides }: ConvexPiece): boolean {
    const [az, ar, bz, br] = [z0[e] as number, r0[e] as number, z1[e] as number, r1[e] as number];
    if ((ar < box.low && br < box.low) || (ar > box.high && br > box.high)) return false;
    if ((az < box.left && bz < box.left) || (az > box.right && bz > box.right)) return false;
    let start = 0;
    let end = 1;
    for (let i = 0; i < sides.length; i += 3) {
      const nz = sides[i] as number;
      const nr = sides[i + 1] as number;
      const c = sides[i + 2] as number;
      const a = nz * az + nr * ar - c;
      const b = nz * bz + nr * br - c;
      if (a >= 0 && b >= 0) return false;
      if (a > 0) start = Math.max(start, a / (a - b));
      else if (b > 0) end = Math.min(end, a / (a - b));
      if (start >= end) return false;
    }
    return true;
  }

  /** Whether a point lies inside: sums the directions of the edges above it. */
  function holds(z: number, r: number): boolean {
    let winding = 0;
    const c = columnOf(z);
    for (let i = begins[c] as number; i < (begins[c + 1] as number); i += 1) {
      const e = list[i] as number;
      const [az, bz] = [z0[e] as number, z1[e] as number];
      if (az <= z === bz <= z) continue;
      const [ar, br] = [r0[e] as number, r1[e] as number];
      if (ar + ((br - ar) * (z - az)) / (bz - az) > r) winding += az <= z ? 1 : -1;
    }
    return winding !== 0;
  }

  return {
    meets(piece) {
      const { box } = piece;
      if (count === 0 || !(box.right > left && box.left < right)) return false;
      question += 1;
      const last = columnOf(box.right);
      let beside = true;
      for (let c = columnOf(box.left); c <= last; c += 1) {
        if (box.low >= (high[c] as number) || box.high <= (low[c] as number)) continue;
        beside = false;
        for (let i = begins[c] as number; i < (begins[c + 1] as number); i += 1) {
          const e = list[i] as number;
          if (seen[e] === question) continue;
          seen[e] = question;
          if (enters(e, piece)) return true;
        }
      }
      // There is no area above all edges or below all of them.
      if (beside) return false;
      const { ring } = piece;
      if (ring.length < 3) return false;
      const [p, q, s] = [
        ring[0] as Pt,
        ring[Math.floor(ring.length / 3)] as Pt,
        ring[Math.floor((2 * ring.length) / 3)] as Pt,
      ];
      return holds((p.z + q.z + s.z) / 3, (p.r + q.r + s.r) / 3);
    },
  };
}
