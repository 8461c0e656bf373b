import { arcByRadius, arcTangential } from "./arc-forms.ts";
import { at, cross, direction, meet, type Track, type Vector } from "./curve.ts";
import type { Pt, Segment, Turn } from "./point.ts";
import { apart, aside, heading, pointOf, same, type Circle, type Work } from "./solve-work.ts";
import { ROUND, SAME } from "./tolerance.ts";

/** A point moved by a vector. */
export const plus = (a: Vector, b: Vector): Pt => at(a.z + b.z, a.r + b.r);
/** The point at a distance from one point, on the ray to another. */
export const towards = (from: Vector, to: Vector, far: number): Pt => {
  const gap = apart(from, to) || 1;
  return at(from.z + ((to.z - from.z) / gap) * far, from.r + ((to.r - from.r) / gap) * far);
};
const dot = (a: Vector, b: Vector) => a.z * b.z + a.r * b.r;
const minus = (a: Vector, b: Vector): Vector => ({ z: a.z - b.z, r: a.r - b.r });

/** Direction of travel of element i in point p (i − 1 or i); null while it is not known. */
export function way(w: Work, i: number, p: number): Vector | null {
  const angle = w.angle[i] ?? null, circle = w.circle[i] ?? null, point = pointOf(w, p);
  if (angle !== null) return heading(angle);
  if (!circle || circle === "straight" || !point || same(point, circle.centre)) return null;
  return direction({ kind: "arc", from: point, to: point, centre: circle.centre, turn: circle.turn }, point);
}

/** True where element i leaves the one before it tangentially. */
export const tangent = (w: Work, i: number) => w.elements[i]?.tangent === true && i > 1;

/** Directions of lines that follow from their ends or from a tangential neighbour. */
export function findAngles(w: Work): boolean {
  let changed = false;
  w.elements.forEach((e, i) => {
    if (i === 0 || (w.angle[i] ?? null) !== null) return;
    if (e.kind === "arc" && w.circle[i] !== "straight") return;
    const [from, to] = [pointOf(w, i - 1), pointOf(w, i)];
    const ends = from && to && apart(from, to) > SAME ? minus(to, from) : null;
    const found = ends ?? (tangent(w, i) ? way(w, i - 1, i - 1) : null) ?? (tangent(w, i + 1) ? way(w, i + 1, i) : null);
    if (!found) return;
    w.angle[i] = Math.atan2(found.r, found.z);
    changed = true;
  });
  return changed;
}

/** Circles of arcs that follow from centre, radius, ends and neighbours. */
export function findCircles(w: Work): boolean {
  let changed = false;
  w.elements.forEach((e, i) => {
    if (i === 0 || e.kind !== "arc" || (w.circle[i] ?? null) !== null) return;
    const found = circleOf(w, i);
    if (!found) return;
    w.circle[i] = found;
    changed = true;
  });
  return changed;
}

function circleOf(w: Work, i: number): Circle | "straight" | null {
  const e = w.elements[i];
  if (e?.kind !== "arc") return null;
  const [from, to] = [pointOf(w, i - 1), pointOf(w, i)], size = e.radius === null ? null : Math.abs(e.radius);
  if (e.centre) {
    const radius = from ? apart(from, e.centre) : size ?? (to && apart(to, e.centre));
    return radius !== null && radius > SAME && e.turn ? { centre: e.centre, radius, turn: e.turn } : null;
  }
  const before = tangent(w, i) ? way(w, i - 1, i - 1) : null, after = tangent(w, i + 1) ? way(w, i + 1, i) : null;
  if (size !== null && size > SAME && e.turn) {
    if (from && before) return { centre: plus(from, aside(e.turn, before, size)), radius: size, turn: e.turn };
    if (to && after) return { centre: plus(to, aside(e.turn, after, size)), radius: size, turn: e.turn };
    if (from && to) {
      const made = arcByRadius(from, to, e.radius ?? size, e.turn).segment;
      return made?.kind === "arc" ? { centre: made.centre, radius: size, turn: e.turn } : null;
    }
    return circleBetween(w, i, size, e.turn);
  }
  if (size !== null || !from || !to || same(from, to)) return null;
  const made = before ? arcTangential({ kind: "line", from: at(from.z - before.z, from.r - before.r), to: from }, to)
    : after ? backwards(arcTangential({ kind: "line", from: at(to.z + after.z, to.r + after.r), to }, from)) : null;
  if (!made) return null;
  return made.kind === "line" ? "straight" : { centre: made.centre, radius: apart(made.centre, from), turn: made.turn };
}

const backwards = (s: Segment | null): Segment | null =>
  s && (s.kind === "line" ? { kind: "line", from: s.to, to: s.from } : { ...s, from: s.to, to: s.from, turn: s.turn === "cw" ? "ccw" : "cw" });

/** A point of the line on which element i lies; null while that line is not known. */
function onLine(w: Work, i: number): Pt | null {
  const angle = w.angle[i] ?? null;
  if (angle === null) return null;
  for (const p of [i - 1, i]) {
    const point = pointOf(w, p), form = w.forms[p];
    if (point) return point;
    const free = form ? new Set([...form.z.by.keys(), ...form.r.by.keys()]) : null;
    const [only] = free ?? [];
    if (!form || free?.size !== 1 || only === undefined) continue;
    const move = { z: form.z.by.get(only) ?? 0, r: form.r.by.get(only) ?? 0 };
    if (Math.abs(cross(move, heading(angle))) < ROUND) return at(form.z.constant, form.r.constant);
  }
  return null;
}

/** Where the centre of an arc may lie that touches element i on the side to which the arc turns. */
function trackBeside(w: Work, i: number, size: number, turn: Turn): Track | null {
  const circle = w.circle[i] ?? null;
  if (circle && circle !== "straight") return { centre: circle.centre, radius: circle.turn === turn ? Math.abs(circle.radius - size) : circle.radius + size };
  const point = onLine(w, i), angle = w.angle[i] ?? null;
  return point && angle !== null ? { point: plus(point, aside(turn, heading(angle), size)), along: heading(angle) } : null;
}

/** The circle of given size between two things it touches or runs through, one of them not known as a point. */
function circleBetween(w: Work, i: number, size: number, turn: Turn): Circle | null {
  const around = (p: Pt | null): Track | null => p && { centre: p, radius: size };
  const one = tangent(w, i) ? trackBeside(w, i - 1, size, turn) : around(pointOf(w, i - 1));
  const two = tangent(w, i + 1) ? trackBeside(w, i + 1, size, turn) : around(pointOf(w, i));
  if (!one || !two) return null;
  const centres = meet(one, two).map((c) => {
    const [start, end] = [touching(w, i - 1, i - 1, c) ?? pointOf(w, i - 1), touching(w, i + 1, i, c) ?? pointOf(w, i)];
    const [before, after] = [pointOf(w, i - 2), pointOf(w, i + 1)], [lineIn, lineOut] = [w.angle[i - 1] ?? null, w.angle[i + 1] ?? null];
    const wrong = (before && start && lineIn !== null && dot(minus(start, before), heading(lineIn)) < -SAME ? 1 : 0)
      + (after && end && lineOut !== null && dot(minus(after, end), heading(lineOut)) < -SAME ? 1 : 0);
    const sweep = start && end ? sweepOf(start, end, at(c.z, c.r), turn) : 0;
    return { c, wrong, sweep: (w.elements[i]?.kind === "arc" && (w.elements[i].radius ?? 0) < 0) === sweep > Math.PI ? sweep : sweep + 7 };
  }).sort((a, b) => a.wrong - b.wrong || a.sweep - b.sweep);
  const fit = centres.filter((c) => c.wrong === 0);
  w.choices[i] = Math.max(1, fit.length);
  const chosen = fit[w.elements[i]?.choice ?? 0] ?? fit[0] ?? centres[0];
  if (!chosen) w.unreachable.add(i);
  return chosen ? { centre: at(chosen.c.z, chosen.c.r), radius: size, turn } : null;
}

/** How far an arc turns from one point to another, radians, more than 0 and up to a full turn. */
export function sweepOf(from: Vector, to: Vector, centre: Vector, turn: Turn): number {
  const [a, b] = [minus(from, centre), minus(to, centre)];
  const angle = Math.atan2(cross(a, b), dot(a, b)) * (turn === "ccw" ? 1 : -1);
  return angle <= ROUND ? angle + 2 * Math.PI : angle;
}

/** Where a circle about `c` touches element i, when it does and point p between them is not known. */
function touching(w: Work, i: number, p: number, c: Vector): Pt | null {
  if (pointOf(w, p)) return null;
  const circle = w.circle[i] ?? null, angle = w.angle[i] ?? null, point = onLine(w, i);
  if (circle && circle !== "straight") return towards(circle.centre, c, circle.radius);
  return point && angle !== null ? plus(point, { z: heading(angle).z * dot(minus(c, point), heading(angle)), r: heading(angle).r * dot(minus(c, point), heading(angle)) }) : null;
}
