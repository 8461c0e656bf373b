import { spotOn, wayOf, type MillMotion, type MillSpot } from "../../kernel/plane/mill-motion.ts";
import { partSegment, plane, type PlaneSegment } from "../../kernel/plane/plane.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import { coveredOn, type Sweep } from "../sweep.ts";
import { roundRing, PLANE_CHORD } from "./body.ts";

/** Chords of an arc in a side plane. */
const SIDE_PIECES = 48;

/** Part of a motion, as fractions of its path. */
type Span = readonly [from: number, to: number];

/** The part of a straight ramp that is below a height or a hair above it, up to `fraction`; null where none is. */
function spanBelow({ z: from }: MillSpot, { z: to }: MillSpot, height: number, fraction: number): Span | null {
  const [a, b] = [from ?? to, to ?? from];
  if (a === null || b === null) return null;
  const [begins, ends] = [a < height, b < height];
  if (begins && ends) return [0, fraction];
  if (!begins && !ends) return null;
  const crossing = (height - a) / (b - a);
  const span: Span = begins ? [0, Math.min(fraction, crossing)] : [crossing, fraction];
  return span[1] >= span[0] ? span : null;
}

/** Part of a path; an arc with coincident ends is empty, not a full circle. */
function partOf(way: PlaneSegment, from: number, to: number): PlaneSegment {
  if (from <= 0 && to >= 1) return way;
  const [begin, end] = [plane.pointOn(way, from), plane.pointOn(way, to)];
  return way.kind === "line" || (plane.apart(begin, end) <= SAME && to - from < 1 / 2)
    ? { kind: "line", from: begin, to: end }
    : { ...way, from: begin, to: end };
}

/** An arc in a side plane as straight motions. */
function pieces(m: MillMotion): readonly MillMotion[] {
  const { side: _, ...plain } = m;
  const spots = Array.from({ length: SIDE_PIECES + 1 }, (_each, i) => spotOn(m, i / SIDE_PIECES));
  return spots.slice(1).map((to, i) => ({ ...plain, from: spots[i] ?? to, to }));
}

/** The sweep of a flat end mill in the plane while its end is below a height, mm, up to a fraction of a motion. */
export type Sweeper = (m: MillMotion, height: number, fraction?: number) => readonly Sweep[];

/** Caches the outlines of all tools and the sweeps of one motion, which are mostly equal for several heights. */
export function sweeper(): Sweeper {
  const tools = new Map<number, Ring>();
  let last: { readonly m: MillMotion; readonly bySpan: Map<string, Sweep> } | null = null;
  const toolOf = ({ radius }: MillMotion): Ring => {
    const known = tools.get(radius) ?? roundRing(radius);
    tools.set(radius, known);
    return known;
  };
  const sweepOn = (m: MillMotion, [from, to]: Span): Sweep => {
    if (last?.m !== m) last = { m, bySpan: new Map() };
    const key = `${from} ${to}`;
    const sweep = last.bySpan.get(key) ?? coveredOn(toolOf(m), partSegment(partOf(wayOf(m), from, to)), PLANE_CHORD);
    last.bySpan.set(key, sweep);
    return sweep;
  };
  const below: Sweeper = (m, height, fraction = 1) => {
    // Without a known radius or height there is no sweep.
    if (!(m.radius > 0) || !(fraction > 0)) return [];
    if (m.side) {
      const done = fraction * SIDE_PIECES;
      return pieces(m).flatMap((piece, i) => below(piece, height, Math.min(1, done - i)));
    }
    const span = spanBelow(m.from, m.to, height, fraction);
    return span ? [sweepOn(m, span)] : [];
  };
  return below;
}
