import type { Group, Outline } from "../cycles/define.ts";
import { toPart } from "../kernel/geometry/flat.ts";
import { part } from "../kernel/geometry/point.ts";
import type { Place } from "./camera.ts";
import { polygon, polyline } from "./help/marks.ts";
import { PICTOGRAM, type Pictogram } from "./pictogram-box.ts";

/** Where the part ends in the box. */
const EDGE = { left: 4, right: 61, top: 4 } as const;
/** How much one direction may be stretched against the other. */
const STRETCH = 2.5;
/** Rise of a thread's tooth, and its pitch. */
const TOOTH = { rise: 5, pitch: 5 } as const;
/** How far the drawing may cut an arc short, mm: the box is some fifty pixels wide. */
const FINE = 0.1;

/** Which way the contour is open: away from the spindle axis, towards it, or towards the free end. */
type Open = "out" | "in" | "face";

interface Room {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/** How a contour is drawn, apart from its line. */
interface Shape {
  readonly open: Open;
  /** A groove: the part continues at both ends. */
  readonly sunk: boolean;
  /** In face machining: the area to cut is at the bore. */
  readonly bored: boolean;
}

function roomOf({ open, sunk, bored }: Shape): Room {
  if (open === "face") return { left: 24, right: 52, top: sunk || bored ? 13 : 7, bottom: 34 };
  const [left, right] = sunk ? [17, 47] : [20, EDGE.right];
  return open === "out" ? { left, right, top: 8, bottom: 28 } : { left, right, top: 15, bottom: 35 };
}

const spread = (values: readonly number[]) => {
  const [low, high] = [Math.min(...values), Math.max(...values)];
  return { low, long: high - low };
};

/** Fits points into a room, stretched in one direction where that shows more, but not beyond recognition. */
function fitted(points: readonly Place[], room: Room): Place[] {
  const [x, y] = [spread(points.map((p) => p.x)), spread(points.map((p) => p.y))];
  const [wide, high] = [room.right - room.left, room.bottom - room.top];
  const [sx, sy] = [x.long > 0 ? wide / x.long : Infinity, y.long > 0 ? high / y.long : Infinity];
  const [kx, ky] = [Math.min(sx, sy * STRETCH), Math.min(sy, sx * STRETCH)];
  const [left, top] = [room.left + (wide - kx * x.long) / 2, room.top + (high - ky * y.long) / 2];
  return points.map((p) => ({ x: left + (p.x - x.low) * kx, y: top + (p.y - y.low) * ky }));
}

/** The box as the contour sees it: u along it, v out of the material. */
const across = (open: Open) => {
  const [u, v]: ((p: Place) => number)[] =
    open === "face" ? [(p) => p.y, (p) => p.x] : [(p) => p.x, (p) => (open === "out" ? -p.y : p.y)];
  const place = (along: number, out: number): Place =>
    open === "face" ? { x: out, y: along } : { x: along, y: open === "out" ? -out : out };
  return { u: u ?? Number, v: v ?? Number, place };
};

/** Replaces a smooth line by thread teeth. */
function toothed(line: readonly Place[], open: Open): Place[] {
  const [first, last] = [line[0], line.at(-1)];
  if (!first || !last) return [];
  const { u, v, place } = across(open);
  const [long, rise] = [u(last) - u(first), v(last) - v(first)];
  const count = 2 * Math.max(2, Math.round(Math.hypot(long, rise) / TOOTH.pitch));
  return Array.from({ length: count + 1 }, (_, i) =>
    place(u(first) + (long * i) / count, v(first) + (rise * i) / count - (i % 2 ? TOOTH.rise : 0)),
  );
}

/** Where the part ends against the direction in which the contour is open. */
function baseOf({ open }: Shape): number {
  if (open === "face") return EDGE.left;
  return open === "out" ? -PICTOGRAM.axis : EDGE.top;
}

/** The outline of the part: the contour, the stretch beyond each end where the part continues, and its back. */
function bodyOf(line: readonly Place[], shape: Shape): Place[] {
  const { open, sunk } = shape;
  const { u, v, place } = across(open);
  const [low, high] = open === "face" ? [EDGE.top, PICTOGRAM.axis] : [EDGE.left, EDGE.right];
  const [first, last] = [line[0], line.at(-1)];
  if (!first || !last) return [];
  /** The part continues beyond the higher end; of two equal ends it is the one at the chuck. */
  const level = Math.abs(v(first) - v(last)) < 1;
  const beyond = (end: Place, other: Place) => sunk || (level ? u(end) < u(other) : v(end) > v(other));
  const edge = (end: Place, other: Place) => (beyond(end, other) ? place(u(end) < u(other) ? low : high, v(end)) : end);
  const base = baseOf(shape);
  const [from, to] = [edge(first, last), edge(last, first)];
  return [place(u(from), base), from, ...line, to, place(u(to), base)];
}

/** The area between the contour and its highest point. */
function cutOf(line: readonly Place[], open: Open): Place[] {
  const { u, v, place } = across(open);
  const top = Math.max(...line.map(v));
  const [first, last] = [line[0], line.at(-1)];
  return first && last ? [place(u(first), top), ...line, place(u(last), top)] : [];
}

const PASSES: Readonly<Record<Group, Pictogram["passes"]>> = {
  special: "profile",
  longitudinal: "along",
  transverse: "along",
  recessTurning: "sinking",
  recessing: "across",
  thread: "profile",
};

/** The drawing of a contour, and whether it is cut inside; null where there is none. */
export function pictogram(
  group: Group,
  { contour, frame, sunk }: Outline,
): (Pictogram & { readonly inside: boolean }) | null {
  const points = part.flattenedChain(contour, FINE);
  if (points.length === 0) return null;
  const out = toPart(frame, { u: 0, v: 1 });
  const along = toPart(frame, { u: 1, v: 0 });
  const open: Open = frame.transverse ? "face" : out.r > 0 ? "out" : "in";
  const shape: Shape = { open, sunk, bored: frame.transverse && along.r > 0 };
  const smooth = fitted(
    points.map((p) => ({ x: p.z, y: -p.r })),
    roomOf(shape),
  );
  const line = group === "thread" ? toothed(smooth, open) : smooth;
  return {
    body: polygon(bodyOf(line, shape)),
    cut: polygon(cutOf(line, open)),
    contour: polyline(line),
    passes: PASSES[group],
    inside: open === "in" || (shape.bored && !sunk),
  };
}
