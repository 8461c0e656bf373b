import { at, part, type Pt } from "../geometry/point.ts";
import type { Affine } from "./solve-linear.ts";
import { arcRank, byRank, setFoundPoint, pointOf, type Rank, type SolveState } from "./solve-work.ts";
import { ARC_END, ROUND, SAME } from "../tolerance.ts";

const { apart, beyond, difference, dot, heading, meet, sizeOf, sweepOf } = part;

/** A point that depends on one free parameter. */
interface Sliding {
  readonly start: Pt;
  readonly move: Pt;
}

const freeIn = (...forms: readonly Affine[]) => new Set(forms.flatMap((f) => [...f.by.keys()]));
const slide = (w: SolveState, i: number, free: number): Sliding => {
  const form = w.forms[i];
  return {
    start: at(form?.z.constant ?? 0, form?.r.constant ?? 0),
    move: at(form?.z.by.get(free) ?? 0, form?.r.by.get(free) ?? 0),
  };
};
const onSlide = (s: Sliding, k: number): Pt => beyond(s.start, s.move, k);

/** Parameters at which |start + k · move| is `far`; the nearest one where it is minimally too far away. */
function atDistance(start: Pt, move: Pt, far: number): number[] {
  const a = dot(move, move);
  if (a < ROUND) return [];
  const middle = -dot(start, move) / a;
  const nearest = sizeOf(beyond(start, move, middle));
  if (nearest > far + ARC_END) return [];
  const half = Math.sqrt(Math.max(0, far * far - nearest * nearest) / a);
  return half < ROUND ? [middle] : [middle + half, middle - half];
}

/** Possible places of a point that is not yet determined. */
interface Candidate {
  readonly i: number;
  readonly point: Pt;
}

/** Sets a point to the best of its possible places and records their number. False if there is none. */
function choose(w: SolveState, element: number, candidates: readonly Candidate[]): boolean {
  const rated = candidates
    .map((c) => ({ c, faults: faultsOf(w, c), ...orderOf(w, element, c) }))
    .sort((a, b) => byRank(a, b) || a.c.point.r - b.c.point.r);
  const fit = rated.filter((r) => r.faults === (rated[0]?.faults ?? 0));
  const chosen = fit[w.elements[element]?.choice ?? 0] ?? rated[0];
  if (!chosen) {
    w.unreachable.add(element);
    return false;
  }
  w.choices[element] = Math.max(1, fit.length);
  return setFoundPoint(w, chosen.c.i, chosen.c.point);
}

/** Number of faults of a place: lines that run backwards, arcs without length, places below the axis. */
function faultsOf(w: SolveState, { i, point }: Candidate): number {
  let faults = point.r < -SAME ? 1 : 0;
  for (const [element, from, to] of [
    [i, pointOf(w, i - 1), point],
    [i + 1, point, pointOf(w, i + 1)],
  ] as const) {
    const angle = w.angle[element] ?? null;
    if (!from || !to || !w.elements[element]) continue;
    if (angle !== null && dot(difference(to, from), heading(angle)) < -SAME) faults += 1;
    if (apart(from, to) <= SAME) faults += 1;
  }
  return faults;
}

/**
 * Prefers the likelier place: the shorter arc (the longer one for a negative radius), the shorter distance to the next
 * point, else towards the chuck.
 */
function orderOf(w: SolveState, element: number, { i, point }: Candidate): Omit<Rank, "faults"> {
  const circle = w.circle[element] ?? null,
    e = w.elements[element];
  const from = i === element ? pointOf(w, element - 1) : point,
    to = i === element ? point : pointOf(w, element);
  if (!circle || circle === "straight" || e?.kind !== "arc" || !from || !to) {
    const [before, after] = [pointOf(w, i - 1), pointOf(w, i + 1)];
    return { otherWay: 0, detour: before && after ? apart(before, point) + apart(point, after) : point.z };
  }
  return arcRank(e, sweepOf({ kind: "arc", from, to, centre: circle.centre, turn: circle.turn }));
}

/** Determines one point by a length or a circle; the first that is possible. True when a point was found. */
export function findPlace(w: SolveState): boolean {
  for (let i = 1; i < w.elements.length; i += 1) {
    const e = w.elements[i],
      circle = w.circle[i] ?? null,
      forms = [w.forms[i - 1], w.forms[i]].flatMap((f) => (f ? [f.z, f.r] : []));
    const free = freeIn(...forms);
    const [only] = free;
    if (only === undefined || w.unreachable.has(i)) continue;
    if (e?.kind === "line" && e.length !== null && (w.angle[i] ?? null) === null && free.size === 1) {
      const [a, b] = [slide(w, i - 1, only), slide(w, i, only)];
      const found = atDistance(difference(b.start, a.start), difference(b.move, a.move), e.length);
      const p = pointOf(w, i) ? i - 1 : i;
      if (
        choose(
          w,
          i,
          found.map((k) => ({ i: p, point: onSlide(p === i ? b : a, k) })),
        )
      )
        return true;
    }
    if (circle && circle !== "straight") {
      for (const p of [i, i - 1]) {
        const own = w.forms[p];
        const [one, ...more] = own ? freeIn(own.z, own.r) : [];
        if (one === undefined || more.length > 0) continue;
        const s = slide(w, p, one);
        const found = atDistance(difference(s.start, circle.centre), s.move, circle.radius);
        if (
          choose(
            w,
            i,
            found.map((k) => ({ i: p, point: onSlide(s, k) })),
          )
        )
          return true;
      }
    }
  }
  return findMeeting(w);
}

/** Determines a point known only by two distances: lengths of its lines, or circles it lies on. */
function findMeeting(w: SolveState): boolean {
  for (let i = 0; i < w.elements.length; i += 1) {
    if (w.z[i] !== null || w.r[i] !== null) continue;
    const [one, two] = [distance(w, i, i - 1), distance(w, i + 1, i + 1)];
    if (!one || !two || w.unreachable.has(i)) continue;
    const found = meet(one, two).map((point) => ({ i, point }));
    if (choose(w, i, found)) return true;
  }
  return false;
}

function distance(w: SolveState, element: number, other: number) {
  const e = w.elements[element],
    circle = w.circle[element] ?? null,
    end = pointOf(w, other);
  if (circle && circle !== "straight") return { centre: circle.centre, radius: circle.radius };
  return element > 0 && e?.kind === "line" && e.length !== null && end ? { centre: end, radius: e.length } : null;
}
