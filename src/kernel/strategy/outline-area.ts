import { segmentToPart, toFlat, toPart, type Flat, type FlatSegment, type Frame } from "../geometry/flat.ts";
import { hypotenuse } from "../geometry/vectors.ts";
import { at, part, type Pt, type Ring, type Segment } from "../geometry/point.ts";
import { CHORD, GRID, ROUND } from "../tolerance.ts";

const { flattenedChain } = part;

/** Extension of the finished part beyond the contour, mm. */
const BEYOND = 2000;

/**
 * The finished part under a contour: closed far below it, and continued behind its last point (with `both`, also in
 * front of its first).
 */
export function partUnder(contour: readonly FlatSegment[], frame: Frame, both: boolean): Ring {
  const points = chain(contour, frame);
  const first = contour[0]?.from;
  const last = contour[contour.length - 1]?.to;
  if (!first || !last) return [];
  const deep = Math.min(first.v, last.v) - BEYOND;
  const close: Flat[] = [
    { u: last.u + BEYOND, v: last.v },
    { u: last.u + BEYOND, v: deep },
  ];
  const start: Flat[] = both
    ? [
        { u: first.u - BEYOND, v: deep },
        { u: first.u - BEYOND, v: first.v },
      ]
    : [{ u: first.u, v: deep }];
  return turned([...points, ...[...close, ...start].map((p) => toPart(frame, p))]);
}

/**
 * The area to be removed: between the contour and the level and place of the start point; stock above that level is not
 * included.
 */
export function areaOver(contour: readonly FlatSegment[], frame: Frame, from: number, top: number): Ring {
  const points = chain(contour, frame).map((p) => toFlat(frame, p));
  const [first, last] = [points[0], points[points.length - 1]];
  if (!first || !last) return [];
  const level = Math.max(top, last.v, first.v);
  const front = Math.min(from, first.u);
  const corners: Flat[] = [
    { u: last.u, v: level },
    { u: front, v: level },
    { u: front, v: first.v },
  ];
  return turned([...under(points, level), ...corners].map((p) => toPart(frame, p)));
}

/** The area to be removed where the blank runs along the contour: between the two, on this side of the axis. */
export function areaBetween(contour: readonly FlatSegment[], blank: readonly Segment[], frame: Frame): Ring {
  const outer = flattenedChain(blank, CHORD).map((p) => (p.r < 0 ? at(p.z, 0) : p));
  return turned([...chain(contour, frame), ...outer.reverse()]);
}

/** The finished part under a contour only: the contour does not define what is next to it. */
export function partBetween(contour: readonly FlatSegment[], frame: Frame): Ring {
  const points = chain(contour, frame);
  const [first, last] = [contour[0]?.from, contour[contour.length - 1]?.to];
  if (!first || !last) return [];
  const deep = Math.min(first.v, last.v) - BEYOND;
  return turned([
    ...points,
    ...[
      { u: last.u, v: deep },
      { u: first.u, v: deep },
    ].map((p) => toPart(frame, p)),
  ]);
}

/** A band of negligible thickness: it joins grooves that would otherwise touch in points only. */
const THREAD_BAND = 0.001;

/** The area between a contour and a line above it, from left to right. */
export function areaUnder(contour: readonly FlatSegment[], over: readonly Flat[], frame: Frame): Ring {
  const top = [...over].reverse().map((p) => toPart(frame, { u: p.u, v: p.v + THREAD_BAND }));
  return turned([...chain(contour, frame), ...top]);
}

/** The area above a line, without a limit. */
export function areaAbove(line: readonly Flat[], frame: Frame): Ring {
  const [first, last] = [line[0], line.at(-1)];
  if (!first || !last) return [];
  const top = Math.max(...line.map((p) => p.v)) + BEYOND;
  return turned([...line, { u: last.u, v: top }, { u: first.u, v: top }].map((p) => toPart(frame, p)));
}

/** A line of points limited to a level, with its intersections with that level. */
function under(points: readonly Flat[], level: number): Flat[] {
  const out: Flat[] = [];
  points.forEach((p, i) => {
    const before = points[i - 1];
    if (before && before.v > level !== p.v > level) {
      const k = (level - before.v) / (p.v - before.v);
      out.push({ u: before.u + k * (p.u - before.u), v: level });
    }
    out.push(p.v > level ? { u: p.u, v: level } : p);
  });
  return out;
}

const chain = (contour: readonly FlatSegment[], frame: Frame) =>
  flattenedChain(
    contour.map((s) => segmentToPart(frame, s)),
    CHORD,
  );

/** Rounded to the grid of the polygon engine: a spike may exist only there. */
const onGrid = ({ z, r }: Pt): Pt => at(Math.round(z / GRID) * GRID, Math.round(r / GRID) * GRID);

/** Counter-clockwise, even if the frame mirrors, and without spikes. */
function turned(spiked: readonly Pt[]): Ring {
  const ring = withoutSpikes(spiked.map(onGrid));
  let twice = 0;
  ring.forEach((p, i) => {
    const q = ring[(i + 1) % ring.length] as Pt;
    twice += p.z * q.r - q.z * p.r;
  });
  return twice < 0 ? [...ring].reverse() : ring;
}

/**
 * A ring without the points at which it turns back on itself, as where a wall of the contour lies in the line that
 * closes it: the polygon engine loses corners next to them.
 */
function withoutSpikes(points: readonly Pt[]): Pt[] {
  const ring = [...points];
  for (let i = 0, sound = 0; sound < ring.length && ring.length > 3;) {
    const [a, b, c] = [ring[(i + ring.length - 1) % ring.length], ring[i], ring[(i + 1) % ring.length]] as [Pt, Pt, Pt];
    const [z0, r0, z1, r1] = [b.z - a.z, b.r - a.r, c.z - b.z, c.r - b.r];
    const size = hypotenuse(z0, r0) * hypotenuse(z1, r1);
    if (size > 0 && (z0 * z1 + r0 * r1 >= 0 || Math.abs(z0 * r1 - r0 * z1) > ROUND * size)) {
      sound += 1;
      i = (i + 1) % ring.length;
      continue;
    }
    ring.splice(i, 1);
    i = (i + ring.length - 1) % ring.length;
    sound = Math.max(0, sound - 2);
  }
  return ring;
}
