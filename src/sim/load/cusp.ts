import type { Convex, Edge } from "../../kernel/reach/convex.ts";
import { support } from "../../kernel/reach/convex.ts";
import { flat, type Flat } from "../../kernel/geometry/flat.ts";
import { positive } from "../../kernel/geometry/segments.ts";
import { ROUND } from "../../kernel/tolerance.ts";

const { angleOf, dot, scaled, sum } = flat;

/** Micrometres in a millimetre. */
const MICRONS = 1000;

/**
 * The cusp height between two revolutions, µm, by the rule of thumb Rz ≈ f²/(8·r). It holds while the feed is well
 * below twice the radius and the nose alone forms the surface. Feed in mm/rev, radius in mm.
 */
export const rzByRule = (feed: number, nose: number): number => (MICRONS * feed * feed) / (8 * nose);

/** Theoretical roughness from which a surface counts as rough, not finished, µm. */
export const ROUGH_RZ = 10;

/**
 * The exact cusp height of the circle, µm: r − √(r² − f²/4); NaN beyond f = 2r, where neighbouring revolutions no
 * longer meet on the nose.
 */
export const rzOfCircle = (feed: number, nose: number): number =>
  MICRONS * (nose - Math.sqrt(nose * nose - (feed * feed) / 4));

/** The cusp between two revolutions of a tool along a straight surface. */
export interface Cusp {
  /** Height from the insert's outline, mm. */
  readonly height: number;
  /**
   * What forms the surface: the nose alone; the nose with an edge, or both flanks ("partly", lower than the rule says);
   * or a straight edge along the surface.
   */
  readonly by: "nose" | "partly" | "edge";
  /** Radius of the nose where it takes part, mm. */
  readonly nose: number | null;
}

interface End {
  readonly along: number;
  readonly edge: Edge;
}

/** Where a line along a surface, `level` mm out from the zero point, crosses the boundary of an insert. */
function crossings(shape: Convex, out: Flat, level: number): End[] {
  const along: Flat = { u: out.v, v: -out.u };
  return shape.flatMap((edge): End[] => {
    if (edge.kind === "line") {
      const [from, to] = [dot(edge.from, out) - level, dot(edge.to, out) - level];
      if (from > 0 === to > 0) return [];
      const t = from / (from - to);
      return [{ along: dot(edge.from, along) * (1 - t) + dot(edge.to, along) * t, edge }];
    }
    const rise = level - dot(edge.centre, out),
      half = Math.sqrt(edge.radius * edge.radius - rise * rise);
    if (!Number.isFinite(half)) return [];
    return [-half, half].flatMap((side) => {
      const angle = angleOf(sum(scaled(along, side), scaled(out, rise)));
      const on = positive(angle - edge.start + ROUND) <= edge.sweep + 2 * ROUND;
      return on ? [{ along: dot(edge.centre, along) + side, edge }] : [];
    });
  });
}

/** The two ends of an insert on a line along the surface; null where it does not cross. */
function widest(
  shape: Convex,
  out: Flat,
  level: number,
): { readonly width: number; readonly ends: readonly [Edge, Edge] } | null {
  const ends = crossings(shape, out, level).sort((a, b) => a.along - b.along);
  const [first, last] = [ends[0], ends.at(-1)];
  return first && last ? { width: last.along - first.along, ends: [first.edge, last.edge] } : null;
}

/** The lowest height of the search, mm: far below any surface. */
const LOWEST = 1e-6;
const HALVINGS = 40;

/**
 * The cusp between two revolutions: the height at which the insert is as wide as the feed, seen along the surface.
 * `out` points out of the work (length 1), `feed` in mm/rev. Null without a feed, or where the insert is narrower than
 * the feed everywhere.
 */
export function cuspOf(shape: Convex, out: Flat, feed: number): Cusp | null {
  if (!(feed > 0) || !Number.isFinite(feed)) return null;
  const floor = dot(support(shape, scaled(out, -1)).at, out);
  const top = dot(support(shape, out).at, out) - floor;
  const widthAt = (height: number) => widest(shape, out, floor + height)?.width ?? 0;
  let high = LOWEST;
  while (widthAt(high) < feed) {
    high *= 2;
    if (high > top) return null;
  }
  if (high === LOWEST) return { height: 0, by: "edge", nose: null };
  let low = high / 2;
  for (let i = 0; i < HALVINGS; i += 1) {
    const middle = (low + high) / 2;
    if (widthAt(middle) < feed) low = middle;
    else high = middle;
  }
  const [first, last] = widest(shape, out, floor + high)?.ends ?? [];
  const nose = [first, last].find((edge) => edge?.kind === "arc" && edge.feature === "nose");
  const radius = nose?.kind === "arc" ? nose.radius : null;
  return { height: high, by: radius !== null && first === last ? "nose" : "partly", nose: radius };
}
