import type { Pt, Ring } from "../kernel/point.ts";
import { GRID } from "../kernel/tolerance.ts";

/** A convex piece that goes less deep than this into an area only touches it: a step of the polygon grid each way. */
const GLANCE = 2 * GRID;

/** A convex piece as half planes n·p ≤ c with unit normals, and its bounding box. */
interface Piece {
  readonly planes: readonly { readonly z: number; readonly r: number; readonly c: number }[];
  readonly low: { readonly z: number; readonly r: number };
  readonly high: { readonly z: number; readonly r: number };
}

function pieceOf(ring: Ring): Piece {
  const planes: { z: number; r: number; c: number }[] = [];
  const low = { z: Infinity, r: Infinity };
  const high = { z: -Infinity, r: -Infinity };
  let p = ring[ring.length - 1] as Pt;
  for (const q of ring) {
    const size = Math.hypot(q.z - p.z, q.r - p.r);
    if (size > GRID) {
      const z = (q.r - p.r) / size;
      const r = (p.z - q.z) / size;
      planes.push({ z, r, c: z * p.z + r * p.r - GLANCE });
    }
    low.z = Math.min(low.z, q.z);
    low.r = Math.min(low.r, q.r);
    high.z = Math.max(high.z, q.z);
    high.r = Math.max(high.r, q.r);
    p = q;
  }
  return { planes, low, high };
}

/** The edges of an area in columns along z, to ask quickly whether a convex piece meets it. */
export interface Edges {
  /** False when the piece surely has no area in common with this one. */
  meets(convex: Ring): boolean;
}

/** Edges per column that we aim at, and the most columns worth keeping. */
const PER_COLUMN = 4;
const MOST_COLUMNS = 1024;

/** Builds the edge columns of an area. Cost grows with the number of its points only. */
export function edgesOf(area: readonly Ring[]): Edges {
  const total = area.reduce((sum, ring) => sum + ring.length, 0);
  const [z0, r0, z1, r1] = Array.from({ length: 4 }, () => new Float64Array(total)) as [Float64Array, Float64Array, Float64Array, Float64Array];
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
  const lists: number[][] = Array.from({ length: columns }, () => []);
  for (let e = 0; e < count; e += 1) {
    const [a, b] = [columnOf(Math.min(z0[e] ?? 0, z1[e] ?? 0)), columnOf(Math.max(z0[e] ?? 0, z1[e] ?? 0))];
    for (let c = a; c <= b; c += 1) lists[c]?.push(e);
  }
  const seen = new Int32Array(count).fill(-1);
  let question = 0;

  /** Whether an edge runs through the inside of a piece: what stays of it after each half plane. */
  function enters(e: number, piece: Piece): boolean {
    const [az, ar, bz, br] = [z0[e] as number, r0[e] as number, z1[e] as number, r1[e] as number];
    if (Math.max(ar, br) < piece.low.r || Math.min(ar, br) > piece.high.r) return false;
    if (Math.max(az, bz) < piece.low.z || Math.min(az, bz) > piece.high.z) return false;
    let [start, end] = [0, 1];
    for (const plane of piece.planes) {
      const a = plane.z * az + plane.r * ar - plane.c;
      const b = plane.z * bz + plane.r * br - plane.c;
      if (a >= 0 && b >= 0) return false;
      if (a > 0) start = Math.max(start, a / (a - b));
      else if (b > 0) end = Math.min(end, a / (a - b));
      if (start >= end) return false;
    }
    return true;
  }

  /** Whether a point lies inside: the edges above it, counted by their direction. */
  function holds(z: number, r: number): boolean {
    let winding = 0;
    for (const e of lists[columnOf(z)] ?? []) {
      const [az, ar, bz, br] = [z0[e] as number, r0[e] as number, z1[e] as number, r1[e] as number];
      if (az <= z === bz <= z) continue;
      if (ar + ((br - ar) * (z - az)) / (bz - az) > r) winding += az <= z ? 1 : -1;
    }
    return winding !== 0;
  }

  return {
    meets(convex) {
      if (count === 0 || convex.length < 3) return false;
      const piece = pieceOf(convex);
      if (!(piece.high.z > left && piece.low.z < right)) return false;
      question += 1;
      const last = columnOf(piece.high.z);
      for (let c = columnOf(piece.low.z); c <= last; c += 1)
        for (const e of lists[c] ?? []) {
          if (seen[e] === question) continue;
          seen[e] = question;
          if (enters(e, piece)) return true;
        }
      const [p, q, s] = [convex[0] as Pt, convex[Math.floor(convex.length / 3)] as Pt, convex[Math.floor((2 * convex.length) / 3)] as Pt];
      return holds((p.z + q.z + s.z) / 3, (p.r + q.r + s.r) / 3);
    },
  };
}
