import { flat, toFlat, mirrors, type Flat, type Frame } from "../geometry/flat.ts";
import { FULL_TURN, positive } from "../geometry/segments.ts";
import { at } from "../geometry/point.ts";
import { JOINED, NOTHING, ROUND } from "../tolerance.ts";

const { angleOf, apart, dot, heading, onCircle, scaled, sum } = flat;

/**
 * Part of the insert that an edge belongs to; `behindMain` and `behindSecondary` are the sides that continue from the
 * end of a cutting edge and do not cut.
 */
export type Feature = "nose" | "mainEdge" | "secondaryEdge" | "width" | "behindMain" | "behindSecondary" | "back";

/**
 * One boundary element of a convex shape, run counter-clockwise. Angles in radians; an arc runs from `start` by `sweep`
 * > 0.
 */
export type Edge =
  | { readonly kind: "line"; readonly from: Flat; readonly to: Flat; readonly feature: Feature }
  | {
      readonly kind: "arc";
      readonly centre: Flat;
      readonly radius: number;
      readonly start: number;
      readonly sweep: number;
      readonly feature: Feature;
    };

/** A convex shape: closed boundary, counter-clockwise, lines and arcs. */
export type Convex = readonly Edge[];

export const edgeStart = (e: Edge): Flat => (e.kind === "line" ? e.from : onCircle(e.centre, e.radius, e.start));
export const edgeEnd = (e: Edge): Flat => (e.kind === "line" ? e.to : onCircle(e.centre, e.radius, e.start + e.sweep));

/** Angle of the outward normal where an edge begins. */
export const normalStart = (e: Edge) =>
  e.kind === "arc" ? e.start : Math.atan2(-(e.to.u - e.from.u), e.to.v - e.from.v);
/** Angle of the outward normal where an edge ends. */
export const normalEnd = (e: Edge) => (e.kind === "arc" ? e.start + e.sweep : normalStart(e));

/**
 * Converts a shape of part space (z as u, r as v) to a frame; a mirroring frame reverses the boundary to keep its turn.
 */
export function inFrame(k: Convex, f: Frame): Convex {
  const map = (p: Flat) => toFlat(f, at(p.u, p.v));
  const angle = (a: number) => angleOf(map(heading(a)));
  if (!mirrors(f))
    return k.map((e) =>
      e.kind === "line"
        ? { ...e, from: map(e.from), to: map(e.to) }
        : { ...e, centre: map(e.centre), start: angle(e.start) },
    );
  return k
    .map((e): Edge =>
      e.kind === "line"
        ? { ...e, from: map(e.to), to: map(e.from) }
        : { ...e, centre: map(e.centre), start: angle(e.start + e.sweep) },
    )
    .reverse();
}

/** The shape moved by an offset. */
export const moved = (k: Convex, by: Flat): Convex =>
  k.map((e) =>
    e.kind === "line" ? { ...e, from: sum(e.from, by), to: sum(e.to, by) } : { ...e, centre: sum(e.centre, by) },
  );

/**
 * Minkowski sum with the rectangle ±a × ±b: arcs are split at the axis directions and shifted, straight lines join
 * them.
 */
export function grown(k: Convex, a: number, b: number): Convex {
  if (a === 0 && b === 0) return k;
  const pieces: Edge[] = k.flatMap(splitAtAxes).map((e) => {
    const middle = e.kind === "arc" ? e.start + e.sweep / 2 : normalStart(e);
    const by = { u: sign(Math.cos(middle)) * a, v: sign(Math.sin(middle)) * b };
    return moved([e], by)[0] as Edge;
  });
  const out: Edge[] = [];
  pieces.forEach((e, i) => {
    out.push(e);
    const next = pieces[(i + 1) % pieces.length] as Edge;
    const from = edgeEnd(e);
    const to = edgeStart(next);
    if (apart(from, to) > NOTHING)
      out.push({ kind: "line", from, to, feature: e.feature === "nose" ? next.feature : e.feature });
  });
  return out;
}
/** Minkowski sum with a disc: every edge moves out by its radius, and arcs at the corners join them. */
export function grownRound(k: Convex, by: number): Convex {
  if (!(by > 0)) return k;
  return k.flatMap((e, i): Edge[] => {
    const next = k[(i + 1) % k.length] as Edge;
    const [start, sweep] = [normalEnd(e), positive(normalStart(next) - normalEnd(e))];
    const edge =
      e.kind === "arc" ? { ...e, radius: e.radius + by } : (moved([e], scaled(heading(normalStart(e)), by))[0] as Edge);
    // Nearly a full turn is a smooth joint with a rounding error.
    if (sweep < JOINED || sweep > FULL_TURN - JOINED) return [edge];
    return [
      edge,
      {
        kind: "arc",
        centre: edgeEnd(e),
        radius: by,
        start,
        sweep,
        feature: e.feature === "nose" ? next.feature : e.feature,
      },
    ];
  });
}
/** Zero for a direction along an axis: such an edge is bridged on both sides. */
const sign = (x: number) => (Math.abs(x) < NOTHING ? 0 : Math.sign(x));

function splitAtAxes(e: Edge): Edge[] {
  if (e.kind === "line") return [e];
  const parts: Edge[] = [];
  let start = e.start;
  const end = e.start + e.sweep;
  while (end - start > NOTHING) {
    const next = Math.min(end, (Math.floor(start / (Math.PI / 2) + ROUND) + 1) * (Math.PI / 2));
    parts.push({ ...e, start, sweep: next - start });
    start = next;
  }
  return parts;
}

/** The boundary point farthest in direction `n`, and its feature; for a whole edge, the end lower in v. */
export function support(k: Convex, n: Flat): { at: Flat; feature: Feature } {
  let best = -Infinity;
  let found: { at: Flat; feature: Feature } = { at: { u: 0, v: 0 }, feature: "nose" };
  const angle = angleOf(n);
  const offer = (at: Flat, feature: Feature) => {
    const d = dot(at, n);
    if (d > best + ROUND || (d > best - ROUND && at.v < found.at.v - ROUND)) {
      best = Math.max(best, d);
      found = { at, feature };
    }
  };
  for (const e of k) {
    if (e.kind === "arc" && positive(angle - e.start + ROUND) <= e.sweep + 2 * ROUND)
      offer(onCircle(e.centre, e.radius, angle), e.feature);
    offer(edgeStart(e), e.feature);
    offer(edgeEnd(e), e.feature);
  }
  return found;
}

/** Extent of a shape along the axes. */
interface Extent {
  readonly minU: number;
  readonly maxU: number;
  readonly minV: number;
  readonly maxV: number;
}

/** Extents of shapes: each is asked for several times in a plan. */
const extents = new WeakMap<Convex, Extent>();

/** Extent of the shape along an axis. */
export function extent(k: Convex): Extent {
  const known = extents.get(k);
  if (known) return known;
  const made = {
    minU: -reach(k, { u: -1, v: 0 }),
    maxU: reach(k, { u: 1, v: 0 }),
    minV: -reach(k, { u: 0, v: -1 }),
    maxV: reach(k, { u: 0, v: 1 }),
  };
  extents.set(k, made);
  return made;
}
const reach = (k: Convex, n: Flat) => dot(support(k, n).at, n);
