import { part, type Pt } from "../../../kernel/geometry/point.ts";
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

/** A plane face meets a circle in two points at most: whether one of them is within its loops. */
function planeCrossing(face: StepFace, plane: Axis3, axis: Axis3): Crossing {
  const local = uprightFrame(plane.origin, plane.direction, null),
    turn = uprightFrame(axis.origin, axis.direction, null);
  const flat = (p: V3): readonly [number, number] => {
    const d = minus(p, local.origin);
    return [dot3(d, local.x), dot3(d, local.y)];
  };
  const loops = loopsOf(face).map((loop) => loop.map(flat)),
    places = pointsOfFace(face).map((p) => sectionPoint(axis, p)),
    [left, right, high] = [
      Math.min(...places.map((p) => p.z)),
      Math.max(...places.map((p) => p.z)),
      Math.max(...places.map((p) => p.r)),
    ];
  const [nx, ny] = [dot3(plane.direction, turn.x), dot3(plane.direction, turn.y)],
    lean = Math.hypot(nx, ny),
    towards = Math.atan2(ny, nx);
  return ({ z, r }) => {
    if (z <= left || z >= right || r >= high) return false;
    const middle = add(axis.origin, times(axis.direction, z)),
      cos = -dot3(plane.direction, minus(middle, plane.origin)) / (r * lean);
    if (!(Math.abs(cos) < 1)) return false;
    return [1, -1].some((side) => {
      const angle = towards + side * Math.acos(cos),
        p = add(middle, add(times(turn.x, r * Math.cos(angle)), times(turn.y, r * Math.sin(angle))));
      return isInRing(loops, flat(p));
    });
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
