import { at, part } from "../../kernel/geometry/point.ts";
import { toScreen, type Camera, type Place } from "../camera.ts";
import type { Dimension, DimensionOf } from "./dimension.ts";
import { middleOf, type LabelBox, type StraightLine } from "./labels.ts";
import { arrowAt, lineThrough, onPaperGrid as n } from "./strokes.ts";

/** The drawing that dimensions are put on: pixels of a screen, or mm on paper. */
export interface DimensionScale {
  readonly camera: Camera;
  /** Units of the paper per pixel of a usual screen: all gaps, arrows and letters scale with it. */
  readonly unit: number;
}

/** One thin line of a dimension, as path data; an arc runs from end to end of its line. */
interface Stroke {
  readonly line: StraightLine;
  readonly d: string;
}

/** Thin lines and filled arrowheads of one dimension. */
interface Drawn {
  readonly strokes: readonly Stroke[];
  readonly arrows: string;
}

/** Thin lines and filled arrowheads of one dimension, as path data, with its lines. */
export interface DrawnDimension {
  readonly lines: string;
  readonly arrows: string;
  readonly pieces: readonly StraightLine[];
}

/** Gap between a place and its extension line, and how far that runs past the dimension line; pixels. */
const GAP = 3,
  PAST = 5;
const ARROW = { long: 9, half: 1.9 } as const;
/** Length of the tail behind an arrow that points inwards, pixels. */
const TAIL = 8;
/** Half of the mark of a centre. */
const CENTRE = 5;
/** How far from its text the line of an ordinate turns to it, pixels. */
const KNEE = 16;

const line = (a: Place, b: Place): Stroke => ({ line: [a, b], d: lineThrough([a, b]) });
const from = (p: Place, way: Place, by: number): Place => ({ x: p.x + way.x * by, y: p.y + way.y * by });
const to = (a: Place, b: Place): { readonly way: Place; readonly long: number } => {
  const long = Math.hypot(b.x - a.x, b.y - a.y);
  return { long, way: long > 0 ? { x: (b.x - a.x) / long, y: (b.y - a.y) / long } : { x: 1, y: 0 } };
};
const dot = (a: Place, b: Place): number => a.x * b.x + a.y * b.y;
const minus = (a: Place, b: Place): Place => ({ x: a.x - b.x, y: a.y - b.y });

const arrow = (tip: Place, way: Place, unit: number): string =>
  arrowAt(tip, way, { long: ARROW.long * unit, half: ARROW.half * unit });

/**
 * A dimension line between two ends with its arrows, inside if they fit and otherwise outside, extended to the text.
 */
function spanned(a: Place, b: Place, text: Place, unit: number): Drawn {
  const { way, long } = to(a, b),
    at_ = dot(minus(text, a), way);
  const isWide = long > (2 * ARROW.long + 4) * unit,
    back = { x: -way.x, y: -way.y };
  const tail = isWide ? 0 : (ARROW.long + TAIL) * unit;
  return {
    strokes: [line(from(a, way, Math.min(-tail, at_)), from(a, way, Math.max(long + tail, at_)))],
    arrows: isWide ? arrow(a, back, unit) + arrow(b, way, unit) : arrow(a, way, unit) + arrow(b, back, unit),
  };
}

/** An extension line from a measured place to its foot on the dimension line, and a little past it. */
function extension(place: Place, foot: Place, unit: number): Stroke[] {
  const { way, long } = to(place, foot);
  return long > (GAP + 1) * unit ? [line(from(place, way, GAP * unit), from(place, way, long + PAST * unit))] : [];
}

const onto = (place: Place, text: Place, way: Place): Place => from(place, way, dot(minus(text, place), way));
const RIGHT: Place = { x: 1, y: 0 },
  DOWN: Place = { x: 0, y: 1 };

/** A dimension between two places whose line runs through its text in a direction. */
function between(a: Place, b: Place, text: Place, across: Place, unit: number): Drawn {
  const [p, q] = [onto(a, text, across), onto(b, text, across)],
    own = spanned(p, q, text, unit);
  return { strokes: [...extension(a, p, unit), ...extension(b, q, unit), ...own.strokes], arrows: own.arrows };
}

/** Across a circle, through its centre. */
function circle({ camera, unit }: DimensionScale, figure: DimensionOf<"circle" | "radius">, text: Place): Drawn {
  const tip = toScreen(camera, figure.at),
    middle = toScreen(camera, figure.centre);
  const other = { x: 2 * middle.x - tip.x, y: 2 * middle.y - tip.y };
  const { way, long } = to(other, tip),
    at_ = dot(minus(text, other), way),
    knee = from(other, way, Math.max(0, Math.min(at_, long)));
  const own = spanned(other, tip, knee, unit);
  return { strokes: [...own.strokes, line(knee, text)], arrows: own.arrows };
}

/** A line from the text to a place, with its arrow there. */
const leader = (end: Place, text: Place, unit: number): Drawn => ({
  strokes: [line(text, end)],
  arrows: arrow(end, to(text, end).way, unit),
});

/** A leader from the text to the arc, and a mark at its centre. */
function radius({ camera, unit }: DimensionScale, figure: DimensionOf<"circle" | "radius">, text: Place): Drawn {
  const own = leader(toScreen(camera, figure.at), text, unit),
    c = toScreen(camera, figure.centre),
    size = CENTRE * unit;
  const mark = [RIGHT, DOWN].map((way) => line(from(c, way, -size), from(c, way, size)));
  return { strokes: [...own.strokes, ...mark], arrows: own.arrows };
}

const bearing = ({ x, y }: Place): number => Math.atan2(-y, x);
const heading = (angle: number): Place => ({ x: Math.cos(angle), y: -Math.sin(angle) });
/** An angle brought into −π … π. */
const short = (angle: number): number => Math.atan2(Math.sin(angle), Math.cos(angle));

function arcLine(centre: Place, far: number, start: number, sweep: number): Stroke {
  const [a, b] = [from(centre, heading(start), far), from(centre, heading(start + sweep), far)];
  return {
    line: [a, b],
    d: `${lineThrough([a])}A${n(far)} ${n(far)} 0 ${Math.abs(sweep) > Math.PI ? 1 : 0} ${sweep > 0 ? 0 : 1} ${n(b.x)} ${n(b.y)}`,
  };
}

/** The legs of an angle on the paper: direction of the first one, and the signed angle to the second, radians. */
export function opening({ camera }: DimensionScale, { vertex, ...ends }: DimensionOf<"angle">) {
  // Ways rather than places: a leg may be too short for the numbers of the screen.
  const turned = (end: typeof vertex): number => {
    const way = part.unit(part.difference(end, vertex));
    return bearing({ x: way.z, y: camera.xUp ? -way.r : way.r });
  };
  const start = turned(ends.from);
  return { centre: toScreen(camera, vertex), start, sweep: short(turned(ends.to) - start) };
}

function angle(paper: DimensionScale, figure: DimensionOf<"angle">, text: Place): Drawn {
  const {
      camera: { scale },
      unit,
    } = paper,
    { centre, start, sweep } = opening(paper, figure);
  const far = Math.max((4 * ARROW.long * unit) / 3, Math.hypot(text.x - centre.x, text.y - centre.y));
  const off = short(bearing(minus(text, centre)) - start),
    share = sweep === 0 ? 0 : off / sweep;
  const leg = (bear: number, end: typeof figure.from): Stroke[] => {
    const [a, b] = [part.apart(end, figure.vertex) * scale + GAP * unit, far + PAST * unit];
    return b > a ? [line(from(centre, heading(bear), a), from(centre, heading(bear), b))] : [];
  };
  const isWide = Math.abs(sweep) * far > (2 * ARROW.long + 4) * unit,
    sense = Math.sign(sweep) || 1;
  const tail = isWide ? 0 : (sense * (ARROW.long + TAIL) * unit) / far;
  const [low, high] = [
    Math.min(-tail * sense, share < 0 ? off * sense : 0),
    Math.max((sweep + tail) * sense, share > 1 ? off * sense : 0),
  ];
  /** The tangent of the arc at an end, leading out of the angle. */
  const out = (bear: number, way: number): Place => ({ x: -Math.sin(bear) * way, y: -Math.cos(bear) * way });
  const [a, b] = [from(centre, heading(start), far), from(centre, heading(start + sweep), far)];
  const inward = isWide ? 1 : -1;
  return {
    strokes: [
      ...leg(start, figure.from),
      ...leg(start + sweep, figure.to),
      arcLine(centre, far, start + low * sense, (high - low) * sense),
    ],
    arrows: arrow(a, out(start, -sense * inward), unit) + arrow(b, out(start + sweep, sense * inward), unit),
  };
}

/** A thin line from a point to the text of its ordinate, which turns to it just before. */
function ordinate({ camera, unit }: DimensionScale, { at: p, of }: DimensionOf<"ordinate">, box: LabelBox): Drawn {
  const place = toScreen(camera, p),
    text = middleOf(box),
    gap = 2 * GAP * unit;
  const knee = (along: number, edge: number) => Math.max(along + gap, edge - KNEE * unit);
  const [start, turn, end] =
    of === "diameter"
      ? [
          { x: place.x + gap, y: place.y },
          { x: knee(place.x, box.x), y: place.y },
          { x: box.x, y: text.y },
        ]
      : [
          { x: place.x, y: place.y + gap },
          { x: place.x, y: knee(place.y, box.y) },
          { x: text.x, y: box.y },
        ];
  return { strokes: [line(start, turn), line(turn, end)], arrows: "" };
}

function drawn(paper: DimensionScale, figure: Dimension, box: LabelBox): Drawn {
  const { camera, unit } = paper,
    text = middleOf(box);
  switch (figure.form) {
    case "diameter": {
      const { z, r } = figure.at;
      return between(toScreen(camera, at(z, r)), toScreen(camera, at(z, -r)), text, RIGHT, unit);
    }
    case "circle":
      return circle(paper, figure, text);
    case "radius":
      return radius(paper, figure, text);
    case "leader":
      return leader(toScreen(camera, figure.at), text, unit);
    case "angle":
      return angle(paper, figure, text);
    case "ordinate":
      return ordinate(paper, figure, box);
    case "z":
    case "r":
    case "along": {
      const [a, b] = [toScreen(camera, figure.from), toScreen(camera, figure.to)],
        { way } = to(a, b);
      const across = { z: DOWN, r: RIGHT, along: { x: -way.y, y: way.x } }[figure.form];
      return between(a, b, text, across, unit);
    }
  }
}

/** The lines of a dimension whose text is in a box of the paper. */
export function drawnDimension(paper: DimensionScale, figure: Dimension, box: LabelBox): DrawnDimension {
  const { strokes, arrows } = drawn(paper, figure, box);
  return { lines: strokes.map(({ d }) => d).join(""), arrows, pieces: strokes.map((each) => each.line) };
}
