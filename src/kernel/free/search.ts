import { FULL_TURN } from "../geometry/segments.ts";
import { plane, type PlanePoint } from "../plane/plane.ts";
import type { Curve, FreeElement } from "./element.ts";
import { leastSquares } from "./least-squares.ts";
import { directionAt, givenAngle, type FreePlaces, type Window } from "./window.ts";

const { apart, difference, dot, heading } = plane;

/** Most start values of a search in total. */
const MOST_STARTS = 60_000;
/** Largest residual of an exact solution. */
const EXACT = 1e-9;
/** Largest deviation from given values, which are rounded to a thousandth, mm. */
export const ROUNDED = 0.006;
/** Precision of a place where curves touch, as a share of the contour's size. */
const TOUCHING = 1e-4;
/** Precision of any other place, and the shortest length that counts, as a share of the contour's size. */
const SEPARATE = 1e-6;
/** Directions whose cosine is nearer to 1 are the same. */
const ONE_WAY = 1e-7;

/** A contour that is being solved. */
export interface Search {
  readonly elements: readonly FreeElement[];
  /** Unit of lengths: the size of the contour. */
  readonly size: number;
  readonly middle: PlanePoint;
  starts: number;
}

/** Evenly spread numbers from 0 to 1, the same in every run (van der Corput). */
function spread(n: number, base: number): number {
  let [value, part] = [0, 1 / base];
  for (let rest = n; rest > 0; rest = Math.floor(rest / base), part /= base) value += (rest % base) * part;
  return value;
}
/** Without 2, so that the numbers do not repeat in step with the reaches. */
const BASES = [3, 5, 7, 11, 13, 17, 19, 23, 29, 31];

/** Most start values are near the given values, some far away. */
const REACHES = [1, 2.5, 0.4, 6] as const;

export function startOf(w: Window, s: Search, n: number): number[] {
  const reach = s.size * (REACHES[n % REACHES.length] ?? 1);
  return w.unknowns.map((kind, i) => {
    const part = spread(n + 1, BASES[i] ?? 37);
    if (kind === "angle") return part * FULL_TURN;
    if (kind === "radius") return part * reach;
    const middle = kind === "x" ? s.middle.x : kind === "y" ? s.middle.y : 0;
    return middle + (part * 2 - 1) * (kind === "offset" ? 2 : 1) * reach;
  });
}

const startsFor = (unknowns: number) => 24 * Math.min(16, 2 ** Math.ceil(unknowns / 1.5));

/** After this many starts that repeat known solutions there is no other: more for more unknowns. */
const enoughRepeats = (unknowns: number) => 12 * 2 ** unknowns;

/** Solutions of a window that run in the right directions; null if they are not separate. */
export function solutionsOf(w: Window, s: Search): readonly FreePlaces[] | null {
  const [exact, near]: [FreePlaces[], FreePlaces[]] = [[], []];
  /**
   * Where curves only just touch, a solution is a double root and seems loose; all starts then converge to the same
   * place.
   */
  const loose: FreePlaces[] = [];
  let repeated = 0;
  for (
    let n = 0;
    n < startsFor(w.unknowns.length) && repeated < enoughRepeats(w.unknowns.length) && s.starts < MOST_STARTS;
    n += 1
  ) {
    s.starts += 1;
    const fit = leastSquares(w.residuals, startOf(w, s, n));
    if (fit.rest > ROUNDED / s.size) continue;
    const made = w.read(fit.at);
    if (!isSound(w, made, s)) continue;
    const list = fit.rest > EXACT ? near : fit.isolated ? exact : loose;
    if (list.some((other) => isSameSolution(w, other, made, list === loose ? TOUCHING * s.size : SEPARATE * s.size)))
      repeated += 1;
    else {
      list.push(made);
      repeated = 0;
    }
    if (loose.length > 2) return null;
  }
  // An aborted search proves nothing.
  if (s.starts >= MOST_STARTS) return null;
  const separate = [
    ...exact,
    ...loose.filter((one) => !exact.some((other) => isSameSolution(w, other, one, TOUCHING * s.size))),
  ];
  return separate.length > 0 ? separate : near;
}

function isSameSolution(w: Window, a: FreePlaces, b: FreePlaces, near: number): boolean {
  for (let k = w.first; k <= w.last; k += 1) {
    const [one, two] = [a.curve(k), b.curve(k)];
    if (
      one?.kind === "line" &&
      two?.kind === "line" &&
      (Math.cos(one.angle - two.angle) < 1 - ONE_WAY || Math.abs(one.offset - two.offset) > near)
    )
      return false;
    if (
      one?.kind === "arc" &&
      two?.kind === "arc" &&
      (apart(one.centre, two.centre) > near || Math.abs(one.radius - two.radius) > near)
    )
      return false;
    const [p, q] = [a.point(k), b.point(k)];
    if (p && q && apart(p, q) > near) return false;
  }
  return true;
}

/** Lines run forwards, arcs have a size, and tangential elements share their direction. */
function isSound(w: Window, found: FreePlaces, { elements, size }: Search): boolean {
  const least = SEPARATE * size;
  for (let k = w.first; k <= w.last; k += 1) {
    const [e, own, from, to] = [elements[k - 1], found.curve(k), found.point(k - 1), found.point(k)];
    if (!e || !own) continue;
    if (own.kind === "arc" && (own.radius < least || own.radius > 100 * size)) return false;
    if (
      from &&
      to &&
      (own.kind === "line"
        ? dot(difference(to, from), heading(own.angle)) < least
        : apart(from, to) < least && e.closes === null)
    )
      return false;
    const before = found.curve(k - 1);
    if (e.tangent && before && from && Math.cos(directionAt(own, from) - directionAt(before, from)) < 0.99)
      return false;
    const angle = givenAngle(e, found);
    if (angle !== null && own.kind === "arc" && from && Math.cos(directionAt(own, from) - angle) < 0.99) return false;
    if (e.sweep !== null && own.kind === "arc" && from && to && Math.abs(sweepOf(own, from, to) - e.sweep) > 0.01)
      return false;
    if (!isPolarSound(e, to)) return false;
  }
  return true;
}

const sweepOf = (own: Extract<Curve, { kind: "arc" }>, from: PlanePoint, to: PlanePoint): number =>
  plane.sweepOf({ kind: "arc", from, to, centre: own.centre, turn: own.turn });

/** An angle from a pole gives a ray, not a whole line. */
function isPolarSound(e: FreeElement, p: PlanePoint | null): boolean {
  const angle = e.polar?.angle;
  return !p || !e.polar || !angle || !("at" in angle) || dot(difference(p, e.polar.pole), heading(angle.at)) >= 0;
}
