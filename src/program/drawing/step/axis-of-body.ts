import { ROUND, SAME } from "../../../kernel/tolerance.ts";
import { part } from "../../../kernel/geometry/point.ts";
import { isSameAxis, meridianParameter, meridianPoint, sectionPoint, type Axis3 } from "./meridian.ts";
import type { SurfacedFace } from "./half-section.ts";
import { pointsOfFace } from "./step-body.ts";
import { minus, times, dot3, type V3 } from "../space.ts";
import { uprightFrame } from "./frame.ts";

/** Axes that are told apart; a body with more has none worth finding. */
const MOST_AXES = 2000;
const TURN = 2 * Math.PI;
/** Points of a full circle are nearer than this, radians. */
const GAP = 0.6;

/** The same line with its greatest component forwards, through the point of it nearest to the origin of the file. */
function canonical({ origin, direction }: Axis3): Axis3 {
  const greatest = direction.reduce<number>((a, b) => (Math.abs(b) > Math.abs(a) + ROUND ? b : a), 0),
    d = greatest < 0 ? times(direction, -1) : direction;
  return { origin: minus(origin, times(d, dot3(origin, d))), direction: d };
}

/** How far round the axis points reach, radians. */
export function turnOf(axis: Axis3, points: readonly V3[]): number {
  const f = uprightFrame(axis.origin, axis.direction, null);
  const angles = points
    .map((p) => minus(p, axis.origin))
    .filter((d) => Math.hypot(dot3(d, f.x), dot3(d, f.y)) > SAME)
    .map((d) => Math.atan2(dot3(d, f.y), dot3(d, f.x)))
    .sort((a, b) => a - b);
  const [first, last] = [angles[0], angles.at(-1)];
  if (first === undefined || last === undefined) return 0;
  const widest = angles.reduce((w, a, i) => Math.max(w, a - (angles[i - 1] ?? a)), first + TURN - last);
  return widest < GAP ? TURN : TURN - widest;
}

/** About how much of a face of revolution there is, mm²; 0 for others. */
export function turnedArea({ face, surface }: SurfacedFace, axis: Axis3): number {
  const m = surface.kind === "plane" ? null : surface.meridian(axis);
  if (!m) return 0;
  const points = pointsOfFace(face),
    places = points.map((p) => sectionPoint(axis, p));
  if (places.length === 0) return 0;
  const along = places.map((p) => meridianParameter(m, p)),
    [from, to] = [Math.min(...along), Math.max(...along)];
  const length = m.kind === "profile" ? part.apart(meridianPoint(m, from), meridianPoint(m, to)) : to - from,
    mean = places.reduce((sum, p) => sum + p.r, 0) / places.length;
  return turnOf(axis, points) * mean * length * (m.kind === "arc" ? m.size : 1);
}

/** A ball has every axis: that of the planes beside it, else the z axis of the file. */
function axisOfBall(faces: readonly SurfacedFace[]): Axis3 | null {
  const ball = faces.find((f) => f.surface.kind === "sphere"),
    centre = ball?.surface.centre;
  if (!centre) return null;
  const plane = faces.find((f) => f.surface.kind === "plane")?.surface.axis;
  return { origin: centre, direction: plane?.direction ?? [0, 0, 1] };
}

/** Axis of revolution of a body: the one with the largest area of faces; null where there is none. */
export function axisOfBody(faces: readonly SurfacedFace[]): { readonly axis: Axis3; readonly area: number } | null {
  const found: { axis: Axis3; area: number }[] = [];
  for (const f of faces) {
    const { axis, kind } = f.surface;
    if (!axis || kind === "plane") continue;
    const area = turnedArea(f, axis),
      known = found.find((a) => isSameAxis(a.axis, axis));
    if (known) known.area += area;
    else if (found.length < MOST_AXES) found.push({ axis, area });
  }
  const best = found.reduce<(typeof found)[number] | null>((a, b) => (a && a.area >= b.area ? a : b), null);
  if (best && best.area > 0) return { axis: canonical(best.axis), area: best.area };
  const axis = axisOfBall(faces);
  return axis && { axis: canonical(axis), area: 0 };
}
