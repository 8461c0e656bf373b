import { plane, type PlanePoint, type PlaneSegment } from "../plane/plane.ts";
import type { Curve, FreeElement, FreeValue, FromPole } from "./element.ts";
import { ROUNDED, solutionsOf, startOf, type Search } from "./search.ts";
import { distanceFrom, endResiduals, windowOf, type FreePlaces, type KnownGeometry, type Window } from "./window.ts";

const { apart, difference, dot, heading, lengthOf } = plane;

/** A solved element. */
export interface FreeSolved {
  readonly segment: PlaneSegment;
  /** False if several contours fit the given values, here or before: the shortest one was taken. */
  readonly certain: boolean;
}

/** Most elements solved together; elements that a control can solve depend on fewer. */
const WIDEST = 5;
const MOST_UNKNOWNS = 10;
/** A closed contour may be longer than an open one by this many sizes of the contour. */
const CLOSED = 1000;
/** Number of later choices tried to see that a solution leads nowhere. */
const AHEAD = 2;

/** Known geometry, and the results of windows without a unique solution: nothing, or the solutions to choose from. */
interface Branch extends KnownGeometry {
  readonly curves: (Curve | null)[];
  readonly points: (PlanePoint | null)[];
  readonly tried: Map<string, Choice | null>;
  readonly uncertain: Set<number>;
}

const copy = (b: Branch): Branch => ({
  curves: [...b.curves],
  points: [...b.points],
  tried: new Map(b.tried),
  uncertain: new Set(b.uncertain),
});

function adopt(b: Branch, w: Window, found: FreePlaces): void {
  for (let k = w.first; k <= w.last; k += 1) {
    b.curves[k] ??= found.curve(k);
    if (k < w.last || found.point(k)) b.points[k] ??= found.point(k);
  }
}

/** Key of a window: which of the values it depends on are known. */
const keyOf = (b: Branch, first: number, last: number): string => {
  let key = `${first}-${last}:`;
  for (let k = first - 1; k <= last + 1; k += 1) key += `${b.curves[k] ? "c" : ""}${b.points[k] ? "p" : ""},`;
  return key;
};

interface Choice {
  readonly window: Window;
  readonly found: readonly FreePlaces[];
}

/** Solves one window: adopts a unique solution, and remembers the choice otherwise. */
function solveWindow(b: Branch, s: Search, first: number, last: number): Choice | null | "unique" | "nowhere" {
  const key = keyOf(b, first, last);
  const before = b.tried.get(key);
  if (before !== undefined) return before;
  const window = windowOf(s.elements, b, first, last, s.size);
  const n = window?.unknowns.length ?? 0;
  if (!window || n === 0 || n > MOST_UNKNOWNS || window.residuals(startOf(window, s, 0)).length < n) return null;
  const found = solutionsOf(window, s);
  if (found?.length === 0) return "nowhere";
  if (found?.length === 1 && found[0]) {
    adopt(b, window, found[0]);
    return "unique";
  }
  const choice = found && { window, found };
  b.tried.set(key, choice);
  return choice;
}

/**
 * Solves everything that needs no choice. Returns the smallest choice left, null if there is none, "nowhere" at a
 * contradiction.
 */
function solveForced(b: Branch, s: Search): Choice | null | "nowhere" {
  for (;;) {
    let [choice, went]: [Choice | null, boolean] = [null, false];
    for (let width = 1; width <= WIDEST && !went; width += 1) {
      for (let first = 1; first + width - 1 <= s.elements.length && !went; first += 1) {
        const made = solveWindow(b, s, first, first + width - 1);
        if (made === "nowhere") return made;
        if (made === "unique") went = true;
        else if (made && (!choice || made.found.length < choice.found.length)) choice = made;
      }
      if (choice && !went) return choice;
    }
    if (!went) return choice;
  }
}

/** Length of the shortest contour that is still possible, within the search depth; null when all choices contradict. */
function shortest(b: Branch, s: Search, depth: number): number | null {
  const next = solveForced(b, s);
  if (next === "nowhere" || !isConsistent(b, s)) return null;
  if (!next || depth === 0) return pathLength(b, s);
  return next.found.reduce((least: number | null, found) => {
    const other = copy(b);
    adopt(other, next.window, found);
    const way = shortest(other, s, depth - 1);
    return way === null || (least !== null && least <= way) ? least : way;
  }, null);
}

function isClosed({ points }: Branch): boolean {
  const [start, end] = [points[0], points.at(-1)];
  return points.length > 2 && !!start && !!end && apart(start, end) < ROUNDED;
}

/** Length of the contour so far; closed contours are preferred over any other. */
const pathLength = (b: Branch, { size }: Search): number =>
  (isClosed(b) ? -CLOSED * size : 0) +
  b.curves.reduce((way, own, i) => {
    const segment = i === 0 ? null : segmentOf(own, b.points[i - 1] ?? null, b.points[i] ?? null);
    return way + (segment ? lengthOf(segment) : 0);
  }, 0);

/** Whether the found geometry agrees with all given values. */
function isConsistent(b: Branch, { elements, size }: Search): boolean {
  const found: FreePlaces = { curve: (k) => b.curves[k] ?? null, point: (k) => b.points[k] ?? null };
  return elements.every((e, i) => {
    const [own, from, to] = [b.curves[i + 1], b.points[i], b.points[i + 1]];
    if (!own || !from || !to) return true;
    const ends = endResiduals(e, i + 1, found, size).every((r) => Math.abs(r) * size < ROUNDED);
    return ends && Math.abs(distanceFrom(own, from)) < ROUNDED && Math.abs(distanceFrom(own, to)) < ROUNDED;
  });
}

function segmentOf(own: Curve | null, from: PlanePoint | null, to: PlanePoint | null): PlaneSegment | null {
  if (!own || !from || !to) return null;
  return own.kind === "line"
    ? { kind: "line", from, to }
    : { kind: "arc", from, to, centre: own.centre, turn: own.turn };
}

const given = (value: FreeValue): number | null => (value && "at" in value ? value.at : null);

/** A point given by its coordinates or from a pole. */
function placeOf(x: FreeValue, y: FreeValue, polar: FromPole | null): PlanePoint | null {
  const [u, v] = [given(x), given(y)];
  if (u !== null && v !== null) return { x: u, y: v };
  const [far, angle] = [given(polar?.radius ?? null), given(polar?.angle ?? null)];
  return polar && far !== null && angle !== null ? plane.beyond(polar.pole, heading(angle), far) : null;
}

function initialBranch(elements: readonly FreeElement[], start: PlanePoint, before: Curve | null): Branch {
  const b: Branch = { curves: [before], points: [start], tried: new Map(), uncertain: new Set() };
  elements.forEach((e, i) => {
    b.points.push(placeOf(e.x, e.y, e.polar) ?? (e.closes === null ? null : (b.points[e.closes] ?? null)));
    const centre = placeOf(e.centreX, e.centreY, e.centrePolar);
    const [from, to] = [b.points[i], b.points[i + 1]];
    // A given point takes precedence over a radius.
    const radius = centre && (from ? apart(from, centre) : (e.radius ?? (to ? apart(to, centre) : null)));
    b.curves.push(e.kind === "arc" && centre && radius ? { kind: "arc", centre, radius, turn: e.turn } : null);
  });
  return b;
}

/** The given lengths of an element, as a measure of the contour's size. */
function lengthsOf(e: FreeElement): number[] {
  const values = [e.x, e.y, e.centreX, e.centreY, e.polar?.radius, e.centrePolar?.radius].map((v) =>
    v && "by" in v ? v.by : null,
  );
  const polar = [e.polar, e.centrePolar].map((p) => given(p?.radius ?? null));
  return [...values, ...polar, e.radius, e.length, e.distancePoint?.distance, e.parallel?.distance].map((n) =>
    Math.abs(n ?? 0),
  );
}

function searchOf(elements: readonly FreeElement[], b: Branch): Search {
  const named = elements.flatMap((e) => [...e.through, e.distancePoint?.point, e.polar?.pole, e.centrePolar?.pole]);
  const places = [...b.points, ...named, ...b.curves.map((c) => (c?.kind === "arc" ? c.centre : null))].filter(
    (p) => p !== null && p !== undefined,
  );
  const [xs, ys] = [
    elements.flatMap((e) => given(e.x) ?? given(e.centreX) ?? []),
    elements.flatMap((e) => given(e.y) ?? given(e.centreY) ?? []),
  ];
  const box = (values: readonly number[]) => [Math.min(...values), Math.max(...values)] as const;
  const [[left, right], [low, high]] = [
    box([...places.map((p) => p.x), ...xs]),
    box([...places.map((p) => p.y), ...ys]),
  ];
  return {
    elements,
    size: Math.max(1, right - left, high - low, ...elements.flatMap(lengthsOf)),
    middle: { x: (left + right) / 2, y: (low + high) / 2 },
    starts: 0,
  };
}

/**
 * Solves a partly given contour from a known point. Elements that depend on their neighbours are solved together. If
 * several contours agree with the given values, the shortest one is taken and marked uncertain.
 * @param before The curve before the contour, for a tangential first element; null if it is not known.
 * @returns The result of each element; null from the first one that is undetermined or contradicts.
 */
export function solveFreeContour(
  elements: readonly FreeElement[],
  start: PlanePoint,
  before: Curve | null,
): (FreeSolved | null)[] {
  const whole = solvedElements(elements, start, before);
  if (whole) return whole;
  // A contradiction: only the elements before it are solved.
  let [sound, wrong] = [0, elements.length];
  let best: readonly (FreeSolved | null)[] = [];
  while (wrong - sound > 1) {
    const middle = (sound + wrong) >> 1;
    const part = solvedElements(elements.slice(0, middle), start, before);
    if (part) [sound, best] = [middle, part];
    else wrong = middle;
  }
  return elements.map((_, i) => best[i] ?? null);
}

/** Indices of undetermined elements: those solved from now on may follow from a choice, on either side of it. */
const undetermined = ({ curves, points }: Branch): number[] =>
  curves.flatMap((own, k) => (k > 0 && (!own || !points[k - 1] || !points[k]) ? [k] : []));

/** The elements as far as they are determined; null at a contradiction. */
function solvedElements(
  elements: readonly FreeElement[],
  start: PlanePoint,
  before: Curve | null,
): (FreeSolved | null)[] | null {
  const b = initialBranch(elements, start, before);
  const s = searchOf(elements, b);
  for (;;) {
    const choice = solveForced(b, s);
    if (choice === "nowhere") return null;
    if (!choice) break;
    const { window } = choice;
    const leading = choice.found.flatMap((found) => {
      const other = copy(b);
      adopt(other, window, found);
      const way = shortest(other, s, AHEAD);
      return way === null ? [] : [{ found, way }];
    });
    const best = leading.toSorted((one, two) => one.way - two.way)[0];
    if (!best) return null;
    if (leading.length > 1) {
      for (const k of undetermined(b)) b.uncertain.add(k);
    }
    adopt(b, window, best.found);
  }
  let ended = false;
  const found: FreePlaces = { curve: (k) => b.curves[k] ?? null, point: (k) => b.points[k] ?? null };
  return elements.map((e, i) => {
    const segment = segmentOf(b.curves[i + 1] ?? null, b.points[i] ?? null, b.points[i + 1] ?? null);
    ended ||= !segment || !isElementConsistent(e, i + 1, segment, found, s.size);
    return ended || !segment ? null : { segment, certain: ![...b.uncertain].some((k) => k <= i + 1) };
  });
}

/** Whether the found geometry agrees with the given values of an element. */
function isElementConsistent(
  e: FreeElement,
  k: number,
  segment: PlaneSegment,
  found: FreePlaces,
  size: number,
): boolean {
  const own = found.curve(k);
  if (!own) return false;
  if (endResiduals(e, k, found, size).some((r) => Math.abs(r) * size > ROUNDED)) return false;
  if (Math.abs(distanceFrom(own, segment.from)) > ROUNDED || Math.abs(distanceFrom(own, segment.to)) > ROUNDED)
    return false;
  if (own.kind === "arc" && e.radius !== null && Math.abs(own.radius - Math.abs(e.radius)) > ROUNDED) return false;
  if (own.kind === "line" && dot(difference(segment.to, segment.from), heading(own.angle)) <= 0) return false;
  return true;
}
