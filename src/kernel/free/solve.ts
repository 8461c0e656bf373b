import { plane, type PlanePoint, type PlaneSegment } from "../plane.ts";
import type { Curve, FreeElement } from "./element.ts";
import { ROUNDED, solutionsOf, startOf, type Search } from "./find.ts";
import { distanceFrom, endResiduals, windowOf, type FreePlaces, type Known, type Window } from "./window.ts";

const { apart, difference, dot, heading, lengthOf } = plane;

/** An element that was found. */
export interface FreeSolved {
  readonly segment: PlaneSegment;
  /** False where several contours fit what is given, here or before: the shortest way was taken. */
  readonly certain: boolean;
}

/** Elements that are solved together at most; those of a control hang together over fewer. */
const WIDEST = 5;
const MOST_UNKNOWNS = 10;
/** How much longer a closed contour may be than one that is not, in sizes of the contour. */
const CLOSED = 1000;
/** How many later choices are looked at to see that a solution leads nowhere. */
const AHEAD = 2;

/** What is known, and which windows brought nothing new. */
interface Branch extends Known {
  readonly curves: (Curve | null)[];
  readonly points: (PlanePoint | null)[];
  readonly tried: Set<string>;
  readonly uncertain: Set<number>;
}

const copy = (b: Branch): Branch => ({
  curves: [...b.curves],
  points: [...b.points],
  tried: new Set(b.tried),
  uncertain: new Set(b.uncertain),
});

function take(b: Branch, w: Window, found: FreePlaces): void {
  for (let k = w.first; k <= w.last; k += 1) {
    b.curves[k] ??= found.curve(k);
    if (k < w.last || found.point(k)) b.points[k] ??= found.point(k);
  }
}

/** Which of the things that a window hangs on are known. */
const keyOf = (b: Branch, first: number, last: number): string => {
  let key = `${first}-${last}:`;
  for (let k = first - 1; k <= last + 1; k += 1) key += `${b.curves[k] ? "c" : ""}${b.points[k] ? "p" : ""},`;
  return key;
};

interface Choice {
  readonly window: Window;
  readonly found: readonly FreePlaces[];
}

/** Finds all that follows without a choice; then the smallest choice that is left, null without one, "nowhere" at a contradiction. */
function follow(b: Branch, s: Search): Choice | null | "nowhere" {
  for (;;) {
    let [choice, went]: [Choice | null, boolean] = [null, false];
    for (let width = 1; width <= WIDEST && !went; width += 1) {
      for (let first = 1; first + width - 1 <= s.elements.length && !went; first += 1) {
        const key = keyOf(b, first, first + width - 1);
        if (b.tried.has(key)) continue;
        const window = windowOf(s.elements, b, first, first + width - 1, s.size);
        const n = window?.unknowns.length ?? 0;
        if (!window || n === 0 || n > MOST_UNKNOWNS || window.residuals(startOf(window, s, 0)).length < n) continue;
        const found = solutionsOf(window, s);
        if (found === null) b.tried.add(key);
        else if (found.length === 0) return "nowhere";
        else if (found.length === 1 && found[0]) {
          take(b, window, found[0]);
          went = true;
        } else if (!choice || found.length < choice.found.length) choice = { window, found };
        if (choice && !went && choice.window === window && width > 1) break;
      }
      if (choice && !went) return choice;
    }
    if (!went) return choice;
  }
}

/** Length of the shortest way that the choices still leave, as far as is looked; null when all of them contradict. */
function shortest(b: Branch, s: Search, depth: number): number | null {
  const next = follow(b, s);
  if (next === "nowhere" || !agrees(b, s)) return null;
  if (!next || depth === 0) return wayOf(b, s);
  return next.found.reduce((least: number | null, found) => {
    const other = copy(b);
    take(other, next.window, found);
    const way = shortest(other, s, depth - 1);
    return way === null || (least !== null && least <= way) ? least : way;
  }, null);
}

function isClosed({ points }: Branch): boolean {
  const [start, end] = [points[0], points.at(-1)];
  return points.length > 2 && !!start && !!end && apart(start, end) < ROUNDED;
}

/** The way so far; contours that come back to their start are likelier than any other. */
const wayOf = (b: Branch, { size }: Search): number =>
  (isClosed(b) ? -CLOSED * size : 0) + b.curves.reduce((way, own, i) => {
    const segment = i === 0 ? null : segmentOf(own, b.points[i - 1] ?? null, b.points[i] ?? null);
    return way + (segment ? lengthOf(segment) : 0);
  }, 0);

/** What was found agrees with everything that is given. */
function agrees(b: Branch, { elements, size }: Search): boolean {
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
  return own.kind === "line" ? { kind: "line", from, to } : { kind: "arc", from, to, centre: own.centre, turn: own.turn };
}

function beginning(elements: readonly FreeElement[], start: PlanePoint, before: Curve | null): Branch {
  const b: Branch = { curves: [before], points: [start], tried: new Set(), uncertain: new Set() };
  elements.forEach((e, i) => {
    const both = e.x && e.y && "at" in e.x && "at" in e.y ? { x: e.x.at, y: e.y.at } : null;
    b.points.push(both ?? (e.closes === null ? null : (b.points[e.closes] ?? null)));
    const centre = e.centreX && e.centreY && "at" in e.centreX && "at" in e.centreY ? { x: e.centreX.at, y: e.centreY.at } : null;
    const [from, to] = [b.points[i], b.points[i + 1]];
    // The point that is given outright counts more than a radius.
    const radius = centre && (from ? apart(from, centre) : (e.radius ?? (to ? apart(to, centre) : null)));
    b.curves.push(e.kind === "arc" && centre && radius ? { kind: "arc", centre, radius, turn: e.turn } : null);
  });
  return b;
}

function searchOf(elements: readonly FreeElement[], b: Branch): Search {
  const places = [...b.points, ...elements.flatMap((e) => e.through), ...b.curves.map((c) => (c?.kind === "arc" ? c.centre : null))].filter(
    (p) => p !== null
  );
  const lengths = elements.flatMap(
    (e) => [
      e.radius,
      e.length,
      e.x && "at" in e.x ? e.x.at - (places[0]?.x ?? 0) : null,
      e.y && "at" in e.y ? e.y.at - (places[0]?.y ?? 0) : null,
    ]
  ).map((n) => Math.abs(n ?? 0));
  const [xs, ys] = [places.map((p) => p.x), places.map((p) => p.y)];
  const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  return {
    elements,
    size: Math.max(1, right - left, high - low, ...lengths),
    middle: { x: (left + right) / 2, y: (low + high) / 2 },
    starts: 0,
  };
}

/**
 * Solves a contour of which only some things are given, from a known point. What follows from neighbouring elements is found
 * together. Where several contours agree with all that is given, the shortest way is taken, and said to be uncertain.
 * @param before What ran before it, for a tangential first element; null where that is not known.
 * @returns For each element what it is; null from the first that is not determined or contradicts.
 */
export function solveFreeContour(elements: readonly FreeElement[], start: PlanePoint, before: Curve | null): (FreeSolved | null)[] {
  const whole = solvedElements(elements, start, before);
  if (whole) return whole;
  // Something contradicts: what stands before it is solved without it.
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

/** The elements as far as they are determined; null where something contradicts. */
function solvedElements(elements: readonly FreeElement[], start: PlanePoint, before: Curve | null): (FreeSolved | null)[] | null {
  const b = beginning(elements, start, before);
  const s = searchOf(elements, b);
  for (;;) {
    const choice = follow(b, s);
    if (choice === "nowhere") return null;
    if (!choice) break;
    const { window } = choice;
    const leading = choice.found.flatMap((found) => {
      const other = copy(b);
      take(other, window, found);
      const way = shortest(other, s, AHEAD);
      return way === null ? [] : [{ found, way }];
    });
    const best = leading.toSorted((one, two) => one.way - two.way)[0];
    if (!best) return null;
    take(b, window, best.found);
    if (leading.length > 1) { for (let k = window.first; k <= window.last; k += 1) b.uncertain.add(k); }
  }
  let open = false;
  const found: FreePlaces = { curve: (k) => b.curves[k] ?? null, point: (k) => b.points[k] ?? null };
  return elements.map((e, i) => {
    const segment = segmentOf(b.curves[i + 1] ?? null, b.points[i] ?? null, b.points[i + 1] ?? null);
    open ||= !segment || !fits(e, i + 1, segment, found, s.size);
    return open || !segment ? null : { segment, certain: ![...b.uncertain].some((k) => k <= i + 1) };
  });
}

/** What was found agrees with what is given of an element. */
function fits(e: FreeElement, k: number, segment: PlaneSegment, found: FreePlaces, size: number): boolean {
  const own = found.curve(k);
  if (!own) return false;
  if (endResiduals(e, k, found, size).some((r) => Math.abs(r) * size > ROUNDED)) return false;
  if (Math.abs(distanceFrom(own, segment.from)) > ROUNDED || Math.abs(distanceFrom(own, segment.to)) > ROUNDED) return false;
  if (own.kind === "arc" && e.radius !== null && Math.abs(own.radius - Math.abs(e.radius)) > ROUNDED) return false;
  if (own.kind === "line" && dot(difference(segment.to, segment.from), heading(own.angle)) <= 0) return false;
  return true;
}
