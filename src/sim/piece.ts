import type { Pt, Ring } from "../kernel/geometry/point.ts";
import { GRID } from "../kernel/tolerance.ts";
import { boxOf } from "../kernel/area/box.ts";
import type { Box } from "../kernel/geometry/segments.ts";

/** A convex piece that overlaps an area by less only touches it: two steps of the polygon grid. */
const GLANCE = 2 * GRID;

/** A convex ring (counter-clockwise) with its box and sides, prepared for many queries. */
export interface ConvexPiece {
  readonly ring: Ring;
  readonly box: Box;
  /** Half planes nz·z + nr·r < c with unit normals, moved inwards by GLANCE: nz, nr, c, nz, nr, c … */
  readonly sides: readonly number[];
}

/** Adds the side from one corner to the next, moved by (z, r), unless it is rounding. */
export function pushSide(sides: number[], p: Pt, q: Pt, z = 0, r = 0): void {
  const dz = q.z - p.z;
  const dr = q.r - p.r;
  const size = Math.sqrt(dz * dz + dr * dr);
  if (size <= GRID) return;
  const nz = dr / size;
  const nr = -dz / size;
  sides.push(nz, nr, nz * (p.z + z) + nr * (p.r + r) - GLANCE);
}

/** Prepares a convex ring. */
export function convexPieceOf(ring: Ring): ConvexPiece {
  // A typed array of this size costs more than all its numbers: a long run makes millions of pieces.
  const sides: number[] = [];
  let p = ring[ring.length - 1] as Pt;
  for (const q of ring) {
    pushSide(sides, p, q);
    p = q;
  }
  return { ring, box: boxOf(ring), sides };
}

/** Prepares several convex rings. */
export const piecesOf = (rings: readonly Ring[]): ConvexPiece[] => rings.map(convexPieceOf);
