import { part, type Pt } from "../../../kernel/geometry/point.ts";
import { FULL_TURN, shortest } from "../../../kernel/geometry/segments.ts";
import { NOTHING } from "../../../kernel/tolerance.ts";
import { add, dot3, minus, times, type V3 } from "../space.ts";
import { uprightFrame } from "./frame.ts";
import type { SurfacedFace } from "./half-section.ts";
import { hullOf, isInHull, isInRing } from "./hull.ts";
import { sectionPoint, type Axis3 } from "./meridian.ts";
import { pointsOfFace, type StepFace } from "./step-body.ts";

/** Whether the circle about the axis through a place of the half section meets a face. */
export type Crossing = (place: Pt) => boolean;

/** The outline of a face in the half section fills at least this share of its hull, unless it is folded at the axis. */
const UNFOLDED = 0.25;

const loopsOf = (face: StepFace): readonly (readonly V3[])[] =>
  face.bounds.map((bound) => bound.flatMap((e) => e.points.slice(0, -1)));

/** Bounds of a face in the half section, outside of which nothing is met; inwards a face may reach beyond its edges. */
function boundsOf(face: StepFace, axis: Axis3): Crossing {
  const places = pointsOfFace(face).map((p) => sectionPoint(axis, p)),
    [left, right, high] = [
      Math.min(...places.map((p) => p.z)),
      Math.max(...places.map((p) => p.z)),
      Math.max(...places.map((p) => p.r)),
    ];
  return ({ z, r }) => z > left && z < right && r < high;
}

/** A plane face meets a circle in two points at most: whether one of them is within its loops. */
function planeCrossing(face: StepFace, plane: Axis3, axis: Axis3): Crossing {
  const local = uprightFrame(plane.origin, plane.direction, null),
    turn = uprightFrame(axis.origin, axis.direction, null);
  const flat = (p: V3): readonly [number, number] => {
    const d = minus(p, local.origin);
    return [dot3(d, local.x), dot3(d, local.y)];
  };
  const loops = loopsOf(face).map((loop) => loop.map(flat)),
    isNear = boundsOf(face, axis);
  const [nx, ny] = [dot3(plane.direction, turn.x), dot3(plane.direction, turn.y)],
    lean = Math.hypot(nx, ny),
    towards = Math.atan2(ny, nx);
  return (place) => {
    if (!isNear(place)) return false;
    const { z, r } = place,
      middle = add(axis.origin, times(axis.direction, z)),
      cos = -dot3(plane.direction, minus(middle, plane.origin)) / (r * lean);
    if (!(Math.abs(cos) < 1)) return false;
    return [1, -1].some((side) => {
      const angle = towards + side * Math.acos(cos),
        p = add(middle, add(times(turn.x, r * Math.cos(angle)), times(turn.y, r * Math.sin(angle))));
      return isInRing(loops, flat(p));
    });
  };
}

/** Places on a circle between which it is looked whether it passes through a cylinder. */
const STEPS = 72;

/** A hole or a rounded wall: where a circle passes through its cylinder, and whether that is within its loops. */
function cylinderCrossing(face: StepFace, bore: Axis3, size: number, axis: Axis3): Crossing {
  const own = uprightFrame(bore.origin, bore.direction, null),
    turn = uprightFrame(axis.origin, axis.direction, null),
    isNear = boundsOf(face, axis);
  const local = (p: V3): V3 => {
    const d = minus(p, own.origin);
    return [dot3(d, own.x), dot3(d, own.y), dot3(d, own.z)];
  };
  const loops = loopsOf(face).map((loop) => loop.map(local).map(([x, y, h]) => ({ angle: Math.atan2(y, x), h })));
  /** By the number of edges above the point, on the cylinder unrolled; loops may go all round it. */
  const isWithin = ([x, y, h]: V3) => {
    const angle = Math.atan2(y, x);
    let isIn = false;
    for (const loop of loops)
      loop.forEach((b, i) => {
        const a = loop.at(i - 1) ?? b,
          from = shortest(a.angle - angle),
          step = shortest(b.angle - a.angle);
        if (from > 0 !== from + step > 0 && a.h + ((b.h - a.h) * -from) / step > h) isIn = !isIn;
      });
    return isIn;
  };
  return (place) => {
    if (!isNear(place)) return false;
    const middle = add(axis.origin, times(axis.direction, place.z));
    const at = (angle: number) =>
      local(add(middle, add(times(turn.x, place.r * Math.cos(angle)), times(turn.y, place.r * Math.sin(angle)))));
    const off = (angle: number) => {
      const [x, y] = at(angle);
      return Math.hypot(x, y) - size;
    };
    for (let i = 0, before = off(0); i < STEPS; i += 1) {
      let [a, b] = [(i * FULL_TURN) / STEPS, ((i + 1) * FULL_TURN) / STEPS];
      const behind = off(b);
      if (before > 0 !== behind > 0) {
        for (let k = 0; k < 30; k += 1) {
          const half = (a + b) / 2;
          if (off(half) > 0 === before > 0) a = half;
          else b = half;
        }
        if (isWithin(at(a))) return true;
      }
      before = behind;
    }
    return false;
  };
}

/** Where circles about the axis meet a face that is not of revolution; null where it has no extent. */
export function crossingOf({ face, surface }: SurfacedFace, axis: Axis3): Crossing | null {
  if (surface.kind === "plane" && surface.axis) {
    const { direction } = surface.axis,
      along = dot3(direction, axis.direction);
    // A plane across the axis is met all at once: nothing is beside it.
    return 1 - along * along < NOTHING ? null : planeCrossing(face, surface.axis, axis);
  }
  const own = surface.kind === "cylinder" && surface.axis,
    round = own ? surface.meridian(own) : null;
  if (own && round?.kind === "line") return cylinderCrossing(face, own, round.origin.r, axis);
  const place = (p: V3) => sectionPoint(axis, p),
    hull = hullOf(pointsOfFace(face).map(place));
  if (!hull) return null;
  const loops = loopsOf(face).map((loop) => loop.map(place)),
    area = loops.reduce((sum, loop) => sum + areaOf(loop), 0);
  if (Math.abs(area) < UNFOLDED * areaOf(hull.points)) return (p) => isInHull(hull, p);
  const flat = loops.map((loop) => loop.map((p): readonly [number, number] => [p.z, p.r]));
  return (p) => isInHull(hull, p) && isInRing(flat, [p.z, p.r]);
}

const areaOf = (loop: readonly Pt[]) =>
  loop.reduce((sum, p, i) => sum + part.cross(p, loop[(i + 1) % loop.length] ?? p), 0) / 2;
