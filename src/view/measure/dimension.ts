import { at, part, type Pt } from "../../kernel/geometry/point.ts";
import { toScreen, type Camera, type Place } from "../camera.ts";
import type { Figure } from "./figure.ts";

/** The drawing that dimensions of measurements are put on: pixels of a screen, or mm on paper. */
export interface DimensionPaper {
  readonly camera: Camera;
  /** Units of the paper per pixel of a usual screen: all gaps, arrows and letters scale with it. */
  readonly unit: number;
}

/** Thin lines and filled arrowheads of one dimension, as path data. */
export interface DimensionLines {
  readonly lines: string;
  readonly arrows: string;
}

/** Gap between a place and its extension line, and how far that runs past the dimension line; pixels. */
const GAP = 3,
  PAST = 5;
const ARROW = { long: 9, half: 1.9 } as const;
/** Length of the tail behind an arrow that points inwards, pixels. */
const TAIL = 8;
/** Half of the mark of a centre. */
const CENTRE = 5;

const n = (v: number): string => String(Math.round(v * 100) / 100 + 0);
const spot = ({ x, y }: Place): string => `${n(x)} ${n(y)}`;
const line = (a: Place, b: Place): string => `M${spot(a)}L${spot(b)}`;
const from = (p: Place, way: Place, by: number): Place => ({ x: p.x + way.x * by, y: p.y + way.y * by });
const to = (a: Place, b: Place): { readonly way: Place; readonly long: number } => {
  const long = Math.hypot(b.x - a.x, b.y - a.y);
  return { long, way: long > 0 ? { x: (b.x - a.x) / long, y: (b.y - a.y) / long } : { x: 1, y: 0 } };
};
const dot = (a: Place, b: Place): number => a.x * b.x + a.y * b.y;
const minus = (a: Place, b: Place): Place => ({ x: a.x - b.x, y: a.y - b.y });

function arrow(tip: Place, way: Place, unit: number): string {
  const back = from(tip, way, -ARROW.long * unit),
    across = { x: -way.y, y: way.x };
  return `M${spot(tip)}L${spot(from(back, across, ARROW.half * unit))}L${spot(from(back, across, -ARROW.half * unit))}Z`;
}

/**
 * A dimension line between two ends with its arrows, inside if they fit and otherwise outside, extended to the text.
 */
function spanned(a: Place, b: Place, text: Place, unit: number): DimensionLines {
  const { way, long } = to(a, b),
    at_ = dot(minus(text, a), way);
  const isWide = long > (2 * ARROW.long + 4) * unit,
    back = { x: -way.x, y: -way.y };
  const tail = isWide ? 0 : (ARROW.long + TAIL) * unit;
  return {
    lines: line(from(a, way, Math.min(-tail, at_)), from(a, way, Math.max(long + tail, at_))),
    arrows: isWide ? arrow(a, back, unit) + arrow(b, way, unit) : arrow(a, way, unit) + arrow(b, back, unit),
  };
}

/** An extension line from a measured place to its foot on the dimension line, and a little past it. */
function extension(place: Place, foot: Place, unit: number): string {
  const { way, long } = to(place, foot);
  return long > (GAP + 1) * unit ? line(from(place, way, GAP * unit), from(place, way, long + PAST * unit)) : "";
}

const onto = (place: Place, text: Place, way: Place): Place => from(place, way, dot(minus(text, place), way));
const RIGHT: Place = { x: 1, y: 0 },
  DOWN: Place = { x: 0, y: 1 };

/** A dimension between two places whose line runs through its text in a direction. */
function between(a: Place, b: Place, text: Place, across: Place, unit: number): DimensionLines {
  const [p, q] = [onto(a, text, across), onto(b, text, across)],
    own = spanned(p, q, text, unit);
  return { lines: extension(a, p, unit) + extension(b, q, unit) + own.lines, arrows: own.arrows };
}

/** Across the axis, from a surface to its mirror image below. */
function diameter(
  { camera, unit }: DimensionPaper,
  { at: { z, r } }: Figure & { readonly kind: "diameter" },
  text: Place,
): DimensionLines {
  return between(toScreen(camera, at(z, r)), toScreen(camera, at(z, -r)), text, RIGHT, unit);
}

/** Across a circle, through its centre. */
function circle(
  { camera, unit }: DimensionPaper,
  figure: Figure & { readonly kind: "circle" },
  text: Place,
): DimensionLines {
  const tip = toScreen(camera, figure.at),
    middle = toScreen(camera, figure.centre);
  const other = { x: 2 * middle.x - tip.x, y: 2 * middle.y - tip.y };
  const { way, long } = to(other, tip),
    at_ = dot(minus(text, other), way),
    knee = from(other, way, Math.max(0, Math.min(at_, long)));
  const own = spanned(other, tip, knee, unit);
  return { lines: own.lines + line(knee, text), arrows: own.arrows };
}

/** A leader from the text to the arc, and a mark at its centre. */
function radius(
  { camera, unit }: DimensionPaper,
  { tip, centre }: Figure & { readonly kind: "radius" },
  text: Place,
): DimensionLines {
  const end = toScreen(camera, tip),
    c = toScreen(camera, centre),
    size = CENTRE * unit;
  return {
    lines:
      line(text, end) +
      line({ x: c.x - size, y: c.y }, { x: c.x + size, y: c.y }) +
      line({ x: c.x, y: c.y - size }, { x: c.x, y: c.y + size }),
    arrows: arrow(end, to(text, end).way, unit),
  };
}

const bearing = ({ x, y }: Place): number => Math.atan2(-y, x);
const heading = (angle: number): Place => ({ x: Math.cos(angle), y: -Math.sin(angle) });
/** An angle brought into −π … π. */
const short = (angle: number): number => Math.atan2(Math.sin(angle), Math.cos(angle));

function arcLine(centre: Place, far: number, start: number, sweep: number): string {
  const [a, b] = [from(centre, heading(start), far), from(centre, heading(start + sweep), far)];
  return `M${spot(a)}A${n(far)} ${n(far)} 0 ${Math.abs(sweep) > Math.PI ? 1 : 0} ${sweep > 0 ? 0 : 1} ${spot(b)}`;
}

/** The legs of an angle on the paper: direction of the first one, and the signed angle to the second, radians. */
export function opening({ camera }: DimensionPaper, { vertex, ways }: Figure & { readonly kind: "angle" }) {
  const centre = toScreen(camera, vertex);
  const turned = (way: Pt): number => bearing(minus(toScreen(camera, part.sum(vertex, way)), centre));
  const start = turned(ways[0]);
  return { centre, start, sweep: short(turned(ways[1]) - start) };
}

function angle(paper: DimensionPaper, figure: Figure & { readonly kind: "angle" }, text: Place): DimensionLines {
  const {
      camera: { scale },
      unit,
    } = paper,
    { centre, start, sweep } = opening(paper, figure);
  const far = Math.max((4 * ARROW.long * unit) / 3, Math.hypot(text.x - centre.x, text.y - centre.y));
  const off = short(bearing(minus(text, centre)) - start),
    share = sweep === 0 ? 0 : off / sweep;
  const leg = (bear: number, reach: number) => {
    const [a, b] = [reach * scale + GAP * unit, far + PAST * unit];
    return b > a ? line(from(centre, heading(bear), a), from(centre, heading(bear), b)) : "";
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
    lines:
      leg(start, figure.reach[0]) +
      leg(start + sweep, figure.reach[1]) +
      arcLine(centre, far, start + low * sense, (high - low) * sense),
    arrows: arrow(a, out(start, -sense * inward), unit) + arrow(b, out(start + sweep, sense * inward), unit),
  };
}

/** A dimension as a drawing shows it, with the middle of its text at a place of the paper. */
export function dimensionLines(paper: DimensionPaper, figure: Figure, text: Place): DimensionLines {
  const { camera, unit } = paper;
  switch (figure.kind) {
    case "diameter":
      return diameter(paper, figure, text);
    case "circle":
      return circle(paper, figure, text);
    case "radius":
      return radius(paper, figure, text);
    case "angle":
      return angle(paper, figure, text);
    case "along":
      return between(toScreen(camera, figure.from), toScreen(camera, figure.to), text, DOWN, unit);
    case "across":
      return between(toScreen(camera, figure.from), toScreen(camera, figure.to), text, RIGHT, unit);
    case "straight": {
      const [a, b] = [toScreen(camera, figure.from), toScreen(camera, figure.to)],
        { way } = to(a, b);
      return between(a, b, text, { x: -way.y, y: way.x }, unit);
    }
  }
}
