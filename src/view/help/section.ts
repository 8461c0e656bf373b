import { part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { along, outward, pointAt, type HelpFrame } from "./frame.ts";
import { ROUND, SAME } from "../../kernel/tolerance.ts";

const { flattenedChain } = part;

/** The drawn section: polygons in part space, and their boundaries. */
export interface Section {
  /** The contour as points. */
  readonly line: readonly Pt[];
  /** The finished part as far as the picture goes. */
  readonly part: readonly Pt[];
  /** Edge of the part that the cycle does not cut: from each contour end outwards. */
  readonly edges: readonly (readonly [Pt, Pt])[];
  /** Where the part is broken off, as lines. */
  readonly breaks: readonly (readonly [Pt, Pt])[];
  /** The outline of the area to be cut, where it is not contour. */
  readonly blank: readonly Pt[];
  /** Corner of the area next to the cycle start point. */
  readonly corner: Pt;
}

/** Where the drawing ends, part space, mm. */
export interface DrawnExtent {
  readonly left: number;
  readonly right: number;
  readonly low: number;
  readonly high: number;
}

/** Chord of a flattened arc against the size of the contour: invisible at any picture size. */
const FINE = 1e-3;

/** Points of a contour, fine enough for any picture. */
export function drawnLine(contour: readonly Segment[]): Pt[] {
  let size = FINE;
  const first = contour[0]?.from;
  if (first) {
    for (const s of contour) size = Math.max(size, Math.abs(s.to.z - first.z), Math.abs(s.to.r - first.r));
  }
  return flattenedChain(contour, size * FINE);
}

/** What closes the area over a contour, from its end up to its highest point and back to its start. */
export function blankOver(f: HelpFrame, line: readonly Pt[]): { readonly blank: Pt[]; readonly corner: Pt } {
  const start = line[0],
    end = line.at(-1);
  if (!start || !end) return { blank: [], corner: pointAt(f, 0, 0) };
  const top = Math.max(...line.map((p) => outward(f, p)));
  const corner = pointAt(f, along(f, start), top);
  const blank = [end, pointAt(f, along(f, end), top), corner, start].filter((p, i, all) => {
    const before = all[i - 1];
    return !before || Math.hypot(p.z - before.z, p.r - before.r) > ROUND;
  });
  return { blank, corner };
}

/**
 * The directions in which the part continues behind the ends of a contour: the deeper end falls away from the open
 * side, other ends continue along the cut.
 */
export function endWays(
  f: HelpFrame,
  line: readonly Pt[],
): { readonly first: "back" | "in"; readonly last: "feed" | "in" } {
  const start = line[0],
    end = line.at(-1);
  const rise = start && end ? outward(f, end) - outward(f, start) : 0;
  return { first: !f.sunk && rise > SAME ? "in" : "back", last: !f.sunk && rise < -SAME ? "in" : "feed" };
}

/** The point where the part meets the edge of the drawing, from a point in a direction of the frame. */
function toEdge(f: HelpFrame, p: Pt, way: "feed" | "back" | "in", reach: DrawnExtent): Pt {
  const u = along(f, p),
    v = outward(f, p);
  const box = [reach.left, reach.right].flatMap((z) => [reach.low, reach.high].map((r) => ({ z, r }) as Pt));
  const us = box.map((c) => along(f, c)),
    vs = box.map((c) => outward(f, c));
  if (way === "in") return pointAt(f, u, Math.min(...vs, v));
  return way === "feed" ? pointAt(f, Math.max(...us, u), v) : pointAt(f, Math.min(...us, u), v);
}

/** The section of a contour inside a drawing. The part continues behind it: to the axis, or to a break line. */
export function sectionOf(f: HelpFrame, line: readonly Pt[], reach: DrawnExtent): Section {
  const { blank, corner } = blankOver(f, line);
  const start = line[0],
    end = line.at(-1);
  if (!start || !end) return { line, part: [], edges: [], breaks: [], blank, corner };
  const ways = endWays(f, line);
  const first = toEdge(f, start, ways.first, reach);
  const last = toEdge(f, end, ways.last, reach);
  const deepest = (p: Pt) => toEdge(f, p, "in", reach);
  const far = [...(ways.last === "in" ? [] : [deepest(last)]), ...(ways.first === "in" ? [] : [deepest(first)])];
  const part = [first, ...line, last, ...far];
  const loop = [...part.slice(line.length + 1), first];
  const onAxis = (a: Pt, b: Pt) => Math.abs(a.r) < SAME && Math.abs(b.r) < SAME;
  const breaks = loop.slice(1).flatMap((b, i) => {
    const a = loop[i];
    return a && Math.hypot(a.z - b.z, a.r - b.r) > SAME && !onAxis(a, b) ? [[a, b] as const] : [];
  });
  return {
    line,
    part,
    edges: [
      [first, start],
      [end, last],
    ],
    breaks,
    blank,
    corner,
  };
}
