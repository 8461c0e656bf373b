import { FULL_TURN } from "../../../kernel/geometry/segments.ts";
import { ROUND } from "../../../kernel/tolerance.ts";
import { radians } from "../../../kernel/units.ts";
import { cross3, objectPlacing, placedCurve, size3, times, UNPLACED, type Curve3, type V3 } from "../space.ts";
import { interpolated, splineOf } from "../splines.ts";
import { flagsAt, realAt, type DxfRecord } from "./document.ts";
import { numberOf } from "./tags.ts";

/** Flags of POLYLINE (70) and VERTEX (70). */
const CLOSED = 1,
  POLYLINE_3D = 8,
  MESH = 16 | 64,
  FRAME_VERTEX = 16;
/** Bulges below this are straight. */
const STRAIGHT = ROUND;

/** A point at these group codes; a missing z is 0, missing x or y are null. */
export function pointAt(r: DxfRecord, code: number): V3 | null {
  const [x, y] = [realAt(r, code), realAt(r, code + 10)];
  return x === null || y === null ? null : [x, y, realAt(r, code + 20) ?? 0];
}

/** Extrusion direction of an entity; the z axis where none is given. */
export const normalOf = (r: DxfRecord): V3 => [realAt(r, 210) ?? 0, realAt(r, 220) ?? 0, realAt(r, 230) ?? 1];

interface Vertex {
  readonly at: V3;
  readonly bulge: number;
}

/** A side of a polyline: the bulge is the tangent of a quarter of the angle it turns through, positive to the left. */
function side(from: Vertex, to: Vertex): Curve3 {
  const b = from.bulge,
    [p, q] = [from.at, to.at];
  if (Math.abs(b) < STRAIGHT) return { kind: "line", from: p, to: q };
  const k = (1 - b * b) / (4 * b),
    [dx, dy] = [q[0] - p[0], q[1] - p[1]];
  const centre: V3 = [(p[0] + q[0]) / 2 - dy * k, (p[1] + q[1]) / 2 + dx * k, p[2]];
  const u: V3 = [p[0] - centre[0], p[1] - centre[1], 0],
    turn = Math.sign(b);
  return { kind: "conic", centre, u, v: [-u[1] * turn, u[0] * turn, 0], start: 0, end: 4 * Math.atan(Math.abs(b)) };
}

function sides(vertices: readonly Vertex[], closed: boolean): Curve3[] | null {
  if (vertices.length < 2) return null;
  return vertices.flatMap((from, i) => {
    const to = vertices[i + 1] ?? (closed ? vertices[0] : undefined);
    return to && size3([to.at[0] - from.at[0], to.at[1] - from.at[1], to.at[2] - from.at[2]]) > 0
      ? [side(from, to)]
      : [];
  });
}

/** Points of repeated groups 10, 20, 30 (or 11, 21, 31), with what follows each. */
function listed(r: DxfRecord, code: number): { at: V3; bulge: number; weight: number }[] {
  const found: { at: [number, number, number]; bulge: number; weight: number }[] = [];
  for (const tag of r.tags) {
    const value = numberOf(tag.text) ?? Number.NaN,
      last = found.at(-1);
    if (tag.code === code) found.push({ at: [value, 0, 0], bulge: 0, weight: 1 });
    else if (last && tag.code === code + 10) last.at[1] = value;
    else if (last && tag.code === code + 20) last.at[2] = value;
    else if (last && tag.code === 42) last.bulge = value;
  }
  return found;
}
const areSound = (all: readonly { readonly at: V3; readonly bulge?: number }[]) =>
  all.every(({ at, bulge = 0 }) => at.every(Number.isFinite) && Number.isFinite(bulge));

function lightPolyline(r: DxfRecord): Curve3[] | null {
  const z = realAt(r, 38) ?? 0;
  const vertices = listed(r, 10).map(({ at, bulge }) => ({ at: [at[0], at[1], z] as const, bulge }));
  return areSound(vertices) ? sides(vertices, (flagsAt(r, 70) & CLOSED) > 0) : null;
}

function oldPolyline(r: DxfRecord): Curve3[] | null | undefined {
  const flags = flagsAt(r, 70);
  if (flags & MESH) return undefined;
  const inSpace = (flags & POLYLINE_3D) > 0,
    z = realAt(r, 30) ?? 0;
  const vertices = r.parts
    .filter((v) => (flagsAt(v, 70) & FRAME_VERTEX) === 0)
    .map((v) => {
      const p = pointAt(v, 10) ?? ([Number.NaN, 0, 0] as const);
      return { at: inSpace ? p : ([p[0], p[1], z] as const), bulge: inSpace ? 0 : (realAt(v, 42) ?? 0) };
    });
  return areSound(vertices) ? sides(vertices, (flags & CLOSED) > 0) : null;
}

function round(r: DxfRecord, start: number, end: number): Curve3[] | null {
  const [centre, size] = [pointAt(r, 10), realAt(r, 40)];
  if (!centre || size === null || size <= 0) return null;
  return [{ kind: "conic", centre, u: [size, 0, 0], v: [0, size, 0], start, end: past(start, end) }];
}
/** The end of an arc behind its start; the same angle is a full turn. */
function past(start: number, end: number): number {
  const turn = (((end - start) % FULL_TURN) + FULL_TURN) % FULL_TURN;
  return start + (turn < ROUND ? FULL_TURN : turn);
}

function ellipse(r: DxfRecord): Curve3[] | null {
  const [centre, u, ratio] = [pointAt(r, 10), pointAt(r, 11), realAt(r, 40)],
    [start, end] = [realAt(r, 41) ?? 0, realAt(r, 42) ?? FULL_TURN],
    z = objectPlacing(normalOf(r))?.z;
  if (!centre || !u || ratio === null || ratio <= 0 || size3(u) === 0 || !z) return null;
  return [{ kind: "conic", centre, u, v: times(cross3(z, u), ratio), start, end: past(start, end) }];
}

function spline(r: DxfRecord): Curve3[] | null {
  const all = (code: number) => r.tags.filter((t) => t.code === code).map((t) => numberOf(t.text) ?? Number.NaN);
  const points = listed(r, 10);
  if (!areSound(points)) return null;
  if (points.length >= 2)
    return splineOf(
      flagsAt(r, 71) || 3,
      all(40),
      points.map((p) => p.at),
      all(41),
    );
  const through = listed(r, 11);
  return areSound(through)
    ? interpolated(
        through.map((p) => p.at),
        (flagsAt(r, 70) & CLOSED) > 0,
      )
    : null;
}

/** Curves of an entity in world coordinates: null for missing or invalid numbers, undefined for no line or curve. */
export function curvesOf(r: DxfRecord): Curve3[] | null | undefined {
  const inObject = (made: Curve3[] | null | undefined) => {
    const placing = objectPlacing(normalOf(r)) ?? UNPLACED;
    return made?.map((c) => placedCurve(placing, c)) ?? made;
  };
  switch (r.type) {
    case "LINE": {
      const [from, to] = [pointAt(r, 10), pointAt(r, 11)];
      return from && to && [{ kind: "line", from, to }];
    }
    case "ARC": {
      const [start, end] = [realAt(r, 50), realAt(r, 51)];
      return start === null || end === null ? null : inObject(round(r, radians(start), radians(end)));
    }
    case "CIRCLE":
      return inObject(round(r, 0, FULL_TURN));
    case "ELLIPSE":
      return ellipse(r);
    case "LWPOLYLINE":
      return inObject(lightPolyline(r));
    case "POLYLINE": {
      const made = oldPolyline(r);
      return (flagsAt(r, 70) & POLYLINE_3D) > 0 ? made : inObject(made);
    }
    case "SPLINE":
    case "HELIX":
      return spline(r);
    default:
      return undefined;
  }
}
