import { at, part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { opposite } from "../../kernel/geometry/segments.ts";
import { ROUND } from "../../kernel/tolerance.ts";
import { diameter, toDiameter, toRadius } from "../../kernel/units.ts";
import type { ContourChoice, DrawnCurve } from "./drawing.ts";
import { fitted } from "./fit.ts";

/** Nearer to the axis than this is on it; ends nearer than this are one point, mm. */
export const TOUCHING = 5e-4;

/** A line or arc of the half that is taken, in part coordinates, and the curve of the drawing it belongs to. */
export interface HalfCurve {
  readonly segment: Segment;
  readonly source: number;
}

/** How a choice maps points of the drawing to the part. */
export function placingOf(choice: ContourChoice): (p: Pt) => Pt {
  const { axis, axisAt, zero, mirrored, half, diameters } = choice;
  return (p) => {
    const [along, across] = axis === "x" ? [p.z, p.r - axisAt] : [p.r, p.z - axisAt],
      up = half === "upper" ? across : -across;
    return at(mirrored ? zero - along : along - zero, diameters ? toRadius(diameter(up)) : up);
  };
}

/** The point of the drawing that a choice maps to a point of the part. */
export function backPlacingOf(choice: ContourChoice): (p: Pt) => Pt {
  const { axis, axisAt, zero, mirrored, half, diameters } = choice;
  return (p) => {
    const along = mirrored ? zero - p.z : zero + p.z,
      up = diameters ? toDiameter(p.r) : p.r,
      across = axisAt + (half === "upper" ? up : -up);
    return axis === "x" ? at(along, across) : at(across, along);
  };
}

/** A curve of the drawing in part coordinates; arcs with distances as diameters are elliptical and fitted. */
export function placedSegments(s: Segment, choice: ContourChoice): Segment[] {
  const put = placingOf(choice);
  if (s.kind === "line") return [part.line(put(s.from), put(s.to))];
  if (choice.diameters) {
    const point = part.pointsOn(s);
    return fitted({ point: (t) => put(point(t)), from: 0, to: 1, detail: 16 });
  }
  const isOver = [choice.axis === "y", choice.half === "lower", choice.mirrored].filter(Boolean).length % 2 === 1;
  const turn = isOver ? opposite(s.turn) : s.turn;
  return [{ kind: "arc", from: put(s.from), to: put(s.to), centre: put(s.centre), turn }];
}

/** The parts of a segment between points on it, in its direction. */
export function splitAt(s: Segment, points: readonly Pt[]): Segment[] {
  if (points.length === 0) return [s];
  const long = part.lengthOf(s),
    places = points
      .map((p) => ({ p, along: part.along(s, p) }))
      .filter(({ along }) => along > ROUND && along < long - ROUND)
      .toSorted((a, b) => a.along - b.along);
  const ends = [s.from, ...places.map(({ p }) => p), s.to];
  return ends.slice(1).flatMap((to, i) => {
    const from = ends[i] ?? to;
    return part.apart(from, to) <= ROUND && ends.length > 2 ? [] : [{ ...s, from, to }];
  });
}

/** Points in which a segment crosses the axis, and in which an arc is farthest to the right and left. */
function cutsOf(s: Segment): Pt[] {
  if (s.kind === "line") {
    const [a, b] = [s.from.r, s.to.r];
    return (a < -TOUCHING && b > TOUCHING) || (a > TOUCHING && b < -TOUCHING)
      ? [at(s.from.z + ((s.to.z - s.from.z) * a) / (a - b), 0)]
      : [];
  }
  const size = part.radiusOf(s),
    reach = Math.sqrt(size ** 2 - s.centre.r ** 2),
    on = [at(s.centre.z - size, s.centre.r), at(s.centre.z + size, s.centre.r)];
  if (reach > TOUCHING) on.push(at(s.centre.z - reach, 0), at(s.centre.z + reach, 0));
  const long = part.lengthOf(s);
  return on.filter((p) => {
    const along = part.along(s, p);
    return along > TOUCHING && along < long - TOUCHING;
  });
}

const onAxis = (p: Pt): Pt => (Math.abs(p.r) <= TOUCHING ? at(p.z, 0) : p);

export interface Half {
  readonly curves: readonly HalfCurve[];
  /** Curves on the axis, and curves that lie on the other side only. */
  readonly axisLines: number;
  readonly otherSide: number;
  /** Farthest reach of each curve to the other side that crosses the axis, mm. */
  readonly below: ReadonlyMap<number, number>;
}

/** The curves of the half that is taken: cut at the axis, without lines along it. `used`: indexes of the drawing. */
export function halfOf(all: readonly DrawnCurve[], used: readonly number[], choice: ContourChoice): Half {
  const curves: HalfCurve[] = [],
    below = new Map<number, number>();
  let axisLines = 0,
    otherSide = 0;
  for (const source of used) {
    const curve = all[source];
    if (!curve) continue;
    const segments = placedSegments(curve.segment, choice),
      boxes = segments.map((s) => part.boxOf(s)),
      low = boxes.reduce((least, b) => Math.min(least, b.low), Infinity),
      high = boxes.reduce((most, b) => Math.max(most, b.high), -Infinity);
    if (high <= TOUCHING) {
      if (low >= -TOUCHING) axisLines += 1;
      else otherSide += 1;
      continue;
    }
    if (low < -TOUCHING) below.set(source, -low);
    for (const s of segments)
      for (const piece of splitAt(s, cutsOf(s))) {
        if (part.pointOn(piece, 1 / 2).r <= 0) continue;
        curves.push({ segment: { ...piece, from: onAxis(piece.from), to: onAxis(piece.to) }, source });
      }
  }
  return { curves, axisLines, otherSide, below };
}
