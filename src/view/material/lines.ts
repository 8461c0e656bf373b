import { hypotenuse } from "../../kernel/geometry/vectors.ts";
import type { Boundary, Columns, Gap } from "./scan.ts";

/** A straight line of the drawing in one half: distances from the axis are positive, mm. */
export interface DrawnLine {
  readonly z0: number;
  readonly r0: number;
  readonly z1: number;
  readonly r1: number;
}

/** The visible stretch of an edge over some columns. */
export interface SeenEdge extends DrawnLine {
  readonly edge: number;
  /** Where the surface begins below it: 0, or the wall of material between it and the axis. */
  readonly low: number;
}

/**
 * The visible stretch of an edge from column `from` to column `to` (exclusive); it continues to the end of the edge if
 * that is near.
 */
function stretch(
  { edges }: Boundary,
  { left, width }: Columns,
  edge: number,
  from: number,
  to: number,
  low: number,
): SeenEdge | null {
  const e = edges[edge];
  if (!e) return null;
  const ends = { z0: Math.min(e.z0, e.z1), z1: Math.max(e.z0, e.z1) };
  const rAt = (z: number) => e.r0 + ((z - e.z0) * (e.r1 - e.r0)) / (e.z1 - e.z0);
  const [begin, end] = [left + from * width, left + to * width];
  const z0 = begin - ends.z0 < 1.5 * width ? ends.z0 : begin,
    z1 = ends.z1 - end < 1.5 * width ? ends.z1 : end;
  return { edge, z0, z1, r0: rAt(z0), r1: rAt(z1), low };
}

/** The visible outside, from left to right. */
export function seenOutside(boundary: Boundary, columns: Columns): readonly SeenEdge[] {
  const out: SeenEdge[] = [];
  let from = 0;
  for (let j = 1; j <= columns.count; j += 1) {
    const edge = columns.edge[from] as number;
    if (j < columns.count && columns.edge[j] === edge) continue;
    const seen = edge < 0 ? null : stretch(boundary, columns, edge, from, j, 0);
    if (seen) out.push(seen);
    from = j;
  }
  return out;
}

/** The visible walls of hollows behind the cut, from left to right. */
export function seenInside(boundary: Boundary, columns: Columns): readonly SeenEdge[] {
  const out: SeenEdge[] = [];
  const open = new Map<number, { from: number; low: number }>();
  for (let j = 0; j <= columns.count; j += 1) {
    const gaps: readonly Gap[] = columns.gaps[j] ?? [];
    for (const [edge, { from, low }] of open) {
      if (gaps.some((gap) => gap.edge === edge)) continue;
      const seen = stretch(boundary, columns, edge, from, j, low);
      if (seen) out.push(seen);
      open.delete(edge);
    }
    for (const { edge, low } of gaps) if (!open.has(edge)) open.set(edge, { from: j, low });
  }
  return out;
}

/** Lines where the outside changes direction: as on a drawing they run from the axis to the edge. */
export function turnsOutside({ corners }: Boundary, { left, width, count, edge }: Columns): readonly DrawnLine[] {
  return corners.flatMap(({ z, r, before, after }) => {
    const j = Math.floor((z - left) / width);
    const isSeen = [j - 2, j - 1, j, j + 1, j + 2].some((k) => {
      const seen = k >= 0 && k < count ? (edge[k] as number) : -1;
      return seen >= 0 && (seen === before || seen === after);
    });
    return isSeen ? [{ z0: z, r0: 0, z1: z, r1: r }] : [];
  });
}

/** Lines where a wall of a hollow changes direction, from the material below it outwards. */
export function turnsInside({ corners }: Boundary, { left, width, gaps }: Columns): readonly DrawnLine[] {
  return corners.flatMap(({ z, r, before, after }) => {
    const j = Math.floor((z - left) / width);
    const gap = [j - 2, j - 1, j, j + 1, j + 2]
      .flatMap((k) => gaps[k] ?? [])
      .find((g) => g.edge === before || g.edge === after);
    return gap && gap.low < r ? [{ z0: z, r0: gap.low, z1: z, r1: r }] : [];
  });
}

/** Feed lines closer than this are not drawn; from the second distance on they have their full strength, pixels. */
export const FEED_LINES = { none: 3, full: 9 } as const;

/** An edge lies along its move if their directions differ by less than this, radians. */
export const FEED_ALONG = 0.02;

/** Feed lines of one strength 0 … 1. */
export interface FeedLines {
  readonly strength: number;
  readonly lines: readonly DrawnLine[];
}

/**
 * The feed marks on visible rough surfaces, one per revolution, counted from where the cut began; none if the scale
 * (pixels per mm) is too small to tell them apart.
 */
export function feedLines({ edges }: Boundary, seen: readonly SeenEdge[], scale: number): readonly FeedLines[] {
  return seen.flatMap(({ edge, z0, r0, z1, r1, low }) => {
    const made = edges[edge]?.made;
    const length = hypotenuse(z1 - z0, r1 - r0);
    if (made?.texture !== "rough" || !(made.pitch > 0) || !(length > 0)) return [];
    if (Math.abs(made.way[0] * (r1 - r0) - made.way[1] * (z1 - z0)) > FEED_ALONG * length) return [];
    const apart = (made.pitch * (z1 - z0)) / length;
    const strength = Math.min(1, (apart * scale - FEED_LINES.none) / (FEED_LINES.full - FEED_LINES.none));
    if (!(strength > 0)) return [];
    const lines: DrawnLine[] = [];
    for (let k = Math.ceil((z0 - made.from) / apart); made.from + k * apart < z1; k += 1) {
      const z = made.from + k * apart;
      lines.push({ z0: z, r0: low, z1: z, r1: r0 + ((r1 - r0) * (z - z0)) / (z1 - z0) });
    }
    return [{ strength, lines }];
  });
}
