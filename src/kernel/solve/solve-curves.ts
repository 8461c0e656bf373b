import type { CurveOf } from "../geometry/curves.ts";
import { at, part, type Pt, type Turn } from "../geometry/point.ts";
import {
  arcRank,
  centreOffset,
  byRank,
  pointOf,
  isSamePoint,
  type Circle,
  type Rank,
  type SolveState,
} from "./solve-work.ts";
import { ROUND, SAME } from "../tolerance.ts";

const {
  angleOf,
  apart,
  arcByRadius,
  arcTangential,
  beyond,
  cross,
  difference,
  direction,
  dot,
  heading,
  line,
  meet,
  reversed,
  sum,
  sweepOf,
  unit,
} = part;

/** The point at a distance from one point, on the ray to another. */
export const pointTowards = (from: Pt, to: Pt, far: number): Pt => beyond(from, unit(difference(to, from)), far);

/** Direction of travel of element i in point p (i − 1 or i); null while it is not known. */
export function travelDirection(w: SolveState, i: number, p: number): Pt | null {
  const angle = w.angle[i] ?? null,
    circle = w.circle[i] ?? null,
    point = pointOf(w, p);
  if (angle !== null) return heading(angle);
  if (!circle || circle === "straight" || !point || isSamePoint(point, circle.centre)) return null;
  return direction({ kind: "arc", from: point, to: point, centre: circle.centre, turn: circle.turn }, point);
}

/** True where element i leaves the one before it tangentially. */
export const isTangent = (w: SolveState, i: number) => w.elements[i]?.tangent === true && i > 1;

/** Finds directions of lines from their ends or from a tangential neighbour. */
export function findAngles(w: SolveState): boolean {
  let changed = false;
  w.elements.forEach((e, i) => {
    if (i === 0 || (w.angle[i] ?? null) !== null) return;
    if (e.kind === "arc" && w.circle[i] !== "straight") return;
    const [from, to] = [pointOf(w, i - 1), pointOf(w, i)];
    const ends = from && to && apart(from, to) > SAME ? difference(to, from) : null;
    const found =
      ends ??
      (isTangent(w, i) ? travelDirection(w, i - 1, i - 1) : null) ??
      (isTangent(w, i + 1) ? travelDirection(w, i + 1, i) : null);
    if (!found) return;
    w.angle[i] = angleOf(found);
    changed = true;
  });
  return changed;
}

/** Finds circles of arcs from centre, radius, ends and neighbours. */
export function findCircles(w: SolveState): boolean {
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

function circleOf(w: SolveState, i: number): Circle | "straight" | null {
  const e = w.elements[i];
  if (e?.kind !== "arc") return null;
  const [from, to] = [pointOf(w, i - 1), pointOf(w, i)],
    size = e.radius === null ? null : Math.abs(e.radius);
  if (e.centre) {
    const radius = from ? apart(from, e.centre) : (size ?? (to && apart(to, e.centre)));
    return radius !== null && radius > SAME && e.turn ? { centre: e.centre, radius, turn: e.turn } : null;
  }
  const before = isTangent(w, i) ? travelDirection(w, i - 1, i - 1) : null,
    after = isTangent(w, i + 1) ? travelDirection(w, i + 1, i) : null;
  if (size !== null && size > SAME && e.turn) {
    if (from && before) return { centre: sum(from, centreOffset(e.turn, before, size)), radius: size, turn: e.turn };
    if (to && after) return { centre: sum(to, centreOffset(e.turn, after, size)), radius: size, turn: e.turn };
    if (from && to) {
      const made = arcByRadius(from, to, e.radius ?? size, e.turn).segment;
      return made?.kind === "arc" ? { centre: made.centre, radius: size, turn: e.turn } : null;
    }
    return circleBetween(w, i, size, e.turn);
  }
  if (size !== null || !from || !to || isSamePoint(from, to)) return null;
  const made = before
    ? arcTangential(line(difference(from, before), from), to)
    : after
      ? arcTangential(line(sum(to, after), to), from)
      : null;
  if (!made) return null;
  // The next neighbour was computed in reverse.
  const own = before ? made : reversed(made);
  return own.kind === "line" ? "straight" : { centre: own.centre, radius: apart(own.centre, from), turn: own.turn };
}

/** A point on the line of element i; null while that line is not known. */
function onLine(w: SolveState, i: number): Pt | null {
  const angle = w.angle[i] ?? null;
  if (angle === null) return null;
  for (const p of [i - 1, i]) {
    const point = pointOf(w, p),
      form = w.forms[p];
    if (point) return point;
    const free = form ? new Set([...form.z.by.keys(), ...form.r.by.keys()]) : null;
    const [only] = free ?? [];
    if (!form || free?.size !== 1 || only === undefined) continue;
    const move = at(form.z.by.get(only) ?? 0, form.r.by.get(only) ?? 0);
    if (Math.abs(cross(move, heading(angle))) < ROUND) return at(form.z.constant, form.r.constant);
  }
  return null;
}

/** Possible centres of an arc that touches element i on the side to which the arc turns. */
function trackBeside(w: SolveState, i: number, size: number, turn: Turn): CurveOf<Pt> | null {
  const circle = w.circle[i] ?? null;
  if (circle && circle !== "straight")
    return {
      centre: circle.centre,
      radius: circle.turn === turn ? Math.abs(circle.radius - size) : circle.radius + size,
    };
  const point = onLine(w, i),
    angle = w.angle[i] ?? null;
  return point && angle !== null
    ? { point: sum(point, centreOffset(turn, heading(angle), size)), along: heading(angle) }
    : null;
}

/** The circle of a given size that touches or contains two neighbours, one of them not known as a point. */
function circleBetween(w: SolveState, i: number, size: number, turn: Turn): Circle | null {
  const around = (p: Pt | null): CurveOf<Pt> | null => p && { centre: p, radius: size };
  const one = isTangent(w, i) ? trackBeside(w, i - 1, size, turn) : around(pointOf(w, i - 1));
  const two = isTangent(w, i + 1) ? trackBeside(w, i + 1, size, turn) : around(pointOf(w, i));
  if (!one || !two) return null;
  const centres = meet(one, two)
    .map((centre) => ({ centre, ...rankOf(w, i, { centre, radius: size, turn }) }))
    .sort(byRank);
  const fit = centres.filter((c) => c.faults === 0);
  w.choices[i] = Math.max(1, fit.length);
  const chosen = fit[w.elements[i]?.choice ?? 0] ?? fit[0] ?? centres[0];
  if (!chosen) w.unreachable.add(i);
  return chosen ? { centre: chosen.centre, radius: size, turn } : null;
}

/** Rank of a circle as element i: number of neighbours that would run backwards, and the angle it turns. */
function rankOf(w: SolveState, i: number, { centre, turn }: Circle): Rank {
  const [start, end] = [
    touching(w, i - 1, i - 1, centre) ?? pointOf(w, i - 1),
    touching(w, i + 1, i, centre) ?? pointOf(w, i),
  ];
  const backwards = (element: number, from: Pt | null, to: Pt | null) => {
    const angle = w.angle[element] ?? null;
    return from && to && angle !== null && dot(difference(to, from), heading(angle)) < -SAME ? 1 : 0;
  };
  const sweep = start && end ? sweepOf({ kind: "arc", from: start, to: end, centre, turn }) : 0;
  return {
    faults: backwards(i - 1, pointOf(w, i - 2), start) + backwards(i + 1, end, pointOf(w, i + 1)),
    ...arcRank(w.elements[i], sweep),
  };
}

/** Point where a circle about `c` touches element i, if it does and point p between them is not known. */
function touching(w: SolveState, i: number, p: number, c: Pt): Pt | null {
  if (pointOf(w, p)) return null;
  const circle = w.circle[i] ?? null,
    angle = w.angle[i] ?? null,
    point = onLine(w, i);
  if (circle && circle !== "straight") return pointTowards(circle.centre, c, circle.radius);
  return point && angle !== null ? beyond(point, heading(angle), dot(difference(c, point), heading(angle))) : null;
}
