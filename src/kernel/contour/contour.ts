import { cutCorner, type CornerElement } from "./corner.ts";
import { selfCrossing } from "./crossing.ts";
import { hypotenuse } from "../geometry/vectors.ts";
import { issue, type Issue } from "../plan/issue.ts";
import type { Groove } from "./groove.ts";
import { part, type Pt, type Segment, type Turn } from "../geometry/point.ts";
import { putRecesses, type ContourChain, type PlacedRecess } from "./recessed.ts";
import { ARC_END, ROUND, SAME } from "../tolerance.ts";
import type { Undercut } from "./undercut.ts";

const { arcByRadius, arcTangential, direction, lengthOf, line } = part;

/** A motion of a programmed contour, in part space, with every coordinate filled in. */
export type PathElement =
  | { readonly kind: "line"; readonly to: Pt }
  /** Radius in mm; negative for the longer arc, as in CR. */
  | { readonly kind: "radius"; readonly to: Pt; readonly radius: number; readonly turn: Turn }
  | { readonly kind: "centre"; readonly to: Pt; readonly centre: Pt; readonly turn: Turn }
  | { readonly kind: "tangent"; readonly to: Pt };
/** One element of a contour subprogram. */
export type ContourElement = PathElement | CornerElement | Undercut | Groove;

export interface Contour {
  readonly segments: readonly Segment[];
  /** Source element of each segment, counted from 1. */
  readonly elements: readonly number[];
  readonly issues: readonly Issue[];
}

/** The largest element of a kind that fits on a corner, mm, when `tooBig` does not fit. */
export function largestCorner(before: Segment, after: Segment, kind: CornerElement["kind"], tooBig: number): number {
  let [low, high] = [0, tooBig];
  for (let i = 0; i < 60; i += 1) {
    const size = (low + high) / 2;
    if (cutCorner(before, after, { kind, size })) low = size;
    else high = size;
  }
  return low;
}

/**
 * Puts chamfers and roundings on the corners of a chain of segments; `corners[i]` belongs to the corner of segments i
 * and i + 1. An element that does not fit is left out and reported with the largest size that fits.
 */
export function withCorners(
  chain: readonly Segment[],
  corners: readonly (CornerElement | null)[],
  numbers: { readonly segments: readonly number[]; readonly corners: readonly number[] } = {
    segments: chain.map((_, i) => i + 1),
    corners: chain.map((_, i) => i + 1),
  },
): Contour {
  const issues: Issue[] = [];
  const parts: Part[] = [];
  let current = chain[0];
  chain.forEach((_, i) => {
    const next = chain[i + 1];
    if (!current) return;
    const own = numbers.segments[i] ?? i + 1;
    const corner = corners[i];
    if (!next || !corner || !(corner.size > 0)) {
      parts.push({ segment: current, element: own });
      current = next;
      return;
    }
    const element = numbers.corners[i] ?? i + 1;
    const cut = bends(current, next) ? cutCorner(current, next, corner) : null;
    parts.push({ segment: cut?.before ?? current, element: own });
    if (cut) parts.push({ segment: cut.between, element });
    else if (corner.kind === "chamfer" && (current.kind === "arc" || next.kind === "arc"))
      issues.push(issue("cornerElementAlone", "error", { element }, "contour"));
    else if (bends(current, next)) {
      const max = largestCorner(current, next, corner.kind, corner.size);
      issues.push(issue("cornerElementTooLong", "error", { element, size: corner.size, max }, "contour"));
    }
    current = cut?.after ?? next;
  });
  const kept = withoutShort(parts);
  return { segments: kept.map((p) => p.segment), elements: kept.map((p) => p.element), issues };
}

/** A piece of a contour with the number of its element. */
interface Part {
  readonly segment: Segment;
  readonly element: number;
}

/**
 * Removes parts too short to have a direction: a neighbouring line is extended over them, else a short line closes the
 * gap.
 */
function withoutShort(parts: readonly Part[]): Part[] {
  const kept: Part[] = [];
  for (const p of parts) {
    const [last, { segment }] = [kept.at(-1), p];
    const short = lengthOf(segment) <= SAME;
    if (last && short && last.segment.kind === "line")
      kept[kept.length - 1] = { ...last, segment: line(last.segment.from, segment.to) };
    else if (last && !short) {
      const gap = line(last.segment.to, segment.from);
      if (segment.kind === "line") kept.push({ ...p, segment: line(gap.from, segment.to) });
      else kept.push(...(lengthOf(gap) > ROUND ? [{ segment: gap, element: p.element }] : []), p);
    } else if (!short) kept.push(p);
  }
  return kept;
}

/** A tangential transition has no corner to break. */
function bends(before: Segment, after: Segment): boolean {
  const [a, b] = [direction(before, before.to), direction(after, after.from)];
  return Math.abs(a.z * b.r - a.r * b.z) > ROUND || a.z * b.z + a.r * b.r < 0;
}

/** Lines between points. */
export const chainOf = (points: readonly Pt[]): Segment[] => points.slice(1).map((to, i) => line(points[i] ?? to, to));

/** The segment of an element that follows `before`; if such an arc is impossible, a line and an issue. */
export function segmentTo(
  from: Pt,
  before: Segment | undefined,
  e: PathElement,
  element: number,
  issues: Issue[],
): Segment {
  switch (e.kind) {
    case "line":
      return line(from, e.to);
    case "radius": {
      const arc = arcByRadius(from, e.to, e.radius, e.turn);
      if (arc.segment) return arc.segment;
      issues.push(issue("arcTooSmall", "error", { element, radius: e.radius }, "contour"));
      return line(from, e.to);
    }
    case "centre": {
      const [start, end] = [from, e.to].map((p) => hypotenuse(p.z - e.centre.z, p.r - e.centre.r)) as [number, number];
      const gap = Math.abs(start - end);
      if (gap <= ARC_END && start > SAME) return { kind: "arc", from, to: e.to, centre: e.centre, turn: e.turn };
      issues.push(issue("arcOffCircle", "error", { element, gap }, "contour"));
      return line(from, e.to);
    }
    case "tangent": {
      const arc = before && arcTangential(before, e.to);
      if (arc) return arc;
      issues.push(issue("contourPoint", "error", { element }, "contour"));
      return line(from, e.to);
    }
  }
}

/** Builds the segments of a programmed contour. Its first element is only the start point. */
export function contourFrom(programmed: readonly ContourElement[]): Contour {
  const issues: Issue[] = [];
  const chain: ContourChain = { segments: [], corners: [], segmentNumbers: [], cornerNumbers: [] };
  const recesses: PlacedRecess[] = [];
  let from: Pt | null = null;
  let waiting: { corner: CornerElement; element: number } | null = null;
  programmed.forEach((e, i) => {
    const element = i + 1;
    if (e.kind === "undercut" || e.kind === "groove") {
      recesses.push({ recess: e, element, after: chain.segments.length - 1 });
      return;
    }
    if ("size" in e) {
      if (chain.segments.length === 0 || waiting)
        issues.push(issue("cornerElementAlone", "error", { element }, "contour"));
      else waiting = { corner: e, element };
      return;
    }
    const segment = from && segmentTo(from, chain.segments.at(-1), e, element, issues);
    from = e.to;
    if (!segment || lengthOf(segment) <= SAME) return;
    if (chain.segments.length > 0) {
      chain.corners.push(waiting?.corner ?? null);
      chain.cornerNumbers.push(waiting?.element ?? 0);
    }
    waiting = null;
    chain.segments.push(segment);
    chain.segmentNumbers.push(element);
  });
  const alone = (waiting as { element: number } | null)?.element;
  if (alone) issues.push(issue("cornerElementAlone", "error", { element: alone }, "contour"));
  if (chain.segments.length === 0) issues.push(issue("contourTooShort", "error", {}, "contour"));
  issues.push(...putRecesses(chain, recesses));
  const done = withCorners(chain.segments, chain.corners, {
    segments: chain.segmentNumbers,
    corners: chain.cornerNumbers,
  });
  const crossing = selfCrossing(done.segments);
  if (crossing) {
    const [element, other] = crossing.map((i) => done.elements[i] ?? 0) as [number, number];
    issues.push(issue("contourCrossesItself", "error", { element, other }, "contour"));
  }
  return { ...done, issues: [...issues, ...done.issues] };
}
