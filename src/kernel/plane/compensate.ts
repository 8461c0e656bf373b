import { issue, type Issue } from "../plan/issue.ts";
import { plane, towardsTool, type PlanePoint, type PlaneSegment, type Side } from "./plane.ts";
import { ROUND, SAME } from "../tolerance.ts";
import { roundedDown } from "../units.ts";

const { along, apart, beyond, cross, direction, dot, lengthOf, line, meetings, radiusOf } = plane;

/** A piece of the centre path. */
export interface CentrePiece {
  readonly segment: PlaneSegment;
  /** Index of its programmed segment; the arc round an outer corner belongs to the segment before the corner. */
  readonly element: number;
  readonly part: "element" | "corner";
}

/** The path of the tool centre along a contour, without gaps; arcs stay arcs. */
export interface Compensated {
  readonly pieces: readonly CentrePiece[];
  /** `element` of an issue counts from 1, as the segments of the contour do. */
  readonly issues: readonly Issue[];
}

/** The centre path along one segment; null when the tool is larger than an inside radius. A point has length 0. */
export function centrePath(s: PlaneSegment, side: Side, radius: number): PlaneSegment | null {
  if (side === "none" || radius === 0) return s;
  const [from, to] = [s.from, s.to].map((p) => beyond(p, towardsTool(direction(s, p), side), radius)) as [
    PlanePoint,
    PlanePoint,
  ];
  if (s.kind === "line") return line(from, to);
  const rest = radiusOf(s) - radius;
  if ((s.turn === "ccw") !== (side === "left") || rest > ROUND) return { ...s, from, to };
  return rest < -ROUND ? null : line(s.centre, s.centre);
}

const isLong = (s: PlaneSegment) => lengthOf(s) > ROUND;

/**
 * Shortened to end or begin in a point; a segment without length becomes a line, because such an arc would be a full
 * circle.
 */
const endingAt = (s: PlaneSegment, to: PlanePoint): PlaneSegment =>
  along(s, to) > ROUND ? { ...s, to } : line(s.from, to);
const beginningAt = (s: PlaneSegment, from: PlanePoint): PlaneSegment =>
  lengthOf(s) - along(s, from) > ROUND ? { ...s, from } : line(from, s.to);

/** Intersection of two neighbouring centre paths that shortens both as little as possible; null when there is none. */
function crossing(before: PlaneSegment, after: PlaneSegment): PlanePoint | null {
  const [longBefore, longAfter] = [lengthOf(before), lengthOf(after)];
  let best: PlanePoint | null = null;
  let loss = Infinity;
  for (const p of meetings(before, after)) {
    const [keep, skip] = [nearZero(along(before, p), before), nearZero(along(after, p), after)];
    const lost = longBefore - keep + skip;
    if (keep < -ROUND || skip < -ROUND || keep > longBefore + ROUND || skip > longAfter + ROUND || lost >= loss)
      continue;
    [best, loss] = [p, lost];
  }
  return best;
}

/** On an arc, a point minimally before its start would count as nearly a full turn: it is taken as the start. */
const nearZero = (far: number, s: PlaneSegment) =>
  s.kind === "arc" && 2 * Math.PI * radiusOf(s) - far < ROUND ? 0 : far;

/** A corner that turns away from the tool needs an arc. */
function turnsAway(before: PlaneSegment, after: PlaneSegment, corner: PlanePoint, side: Side): boolean {
  const [a, b] = [direction(before, corner), direction(after, after.from)];
  const bend = cross(a, b) * (side === "left" ? 1 : -1);
  return bend < -ROUND || (bend < ROUND && dot(a, b) < 0);
}

interface Walk {
  readonly pieces: CentrePiece[];
  /** Indices of segments that the tool is too large for. */
  readonly tooLarge: number[];
}

function walk(contour: readonly PlaneSegment[], side: Side, radius: number): Walk {
  const pieces: CentrePiece[] = [];
  const tooLarge: number[] = [];
  const add = (segment: PlaneSegment, element: number, part: CentrePiece["part"]) => {
    if (isLong(segment)) pieces.push({ segment, element, part });
  };
  let current: { path: PlaneSegment; element: number } | null = null;
  contour.forEach((s, element) => {
    let path = centrePath(s, side, radius);
    if (!path) return void tooLarge.push(element);
    if (!current) {
      current = { path, element };
      return;
    }
    const { path: before, element: last } = current;
    const programmed = contour[last] ?? s;
    const end = before.to;
    if (apart(end, path.from) <= ROUND) {
      if (isLong(path)) path = { ...path, from: end };
      add(before, last, "element");
    } else if (apart(programmed.to, s.from) <= SAME && turnsAway(programmed, s, programmed.to, side)) {
      add(before, last, "element");
      add(
        { kind: "arc", from: end, to: path.from, centre: s.from, turn: side === "left" ? "cw" : "ccw" },
        last,
        "corner",
      );
    } else {
      const at = crossing(before, path);
      if (at) {
        add(endingAt(before, at), last, "element");
        path = beginningAt(path, at);
      } else {
        add(before, last, "element");
        add(line(end, path.from), last, "corner");
        if (apart(end, path.from) > SAME && last + 1 === element)
          tooLarge.push(swallowed(before, path) === "before" ? last : element);
      }
    }
    current = { path, element };
  });
  const left = current as { path: PlaneSegment; element: number } | null;
  if (left) add(left.path, left.element, "element");
  return { pieces, tooLarge };
}

/** The one of two neighbours without an intersection that is too short for this tool. */
const swallowed = (before: PlaneSegment, after: PlaneSegment) =>
  lengthOf(before) < lengthOf(after) ? "before" : "after";

/** Largest tool radius that fits a section of a contour, on the grid a control prints, mm. */
function largestThatFits(contour: readonly PlaneSegment[], side: Side, tooBig: number): number {
  let [low, high] = [0, tooBig];
  for (let i = 0; i < 50; i += 1) {
    const size = (low + high) / 2;
    if (walk(contour, side, size).tooLarge.length === 0) low = size;
    else high = size;
  }
  return roundedDown(low);
}

/**
 * The path of the tool centre along a contour whose segments join. Outer corners get an arc of the tool radius, inner
 * corners are cut where the neighbours meet. Where the tool does not fit, the path continues straight and an issue is
 * reported.
 */
export function compensate(contour: readonly PlaneSegment[], side: Side, radius: number): Compensated {
  const { pieces, tooLarge } = walk(contour, side, radius);
  const issues = [...new Set(tooLarge)].map((i) => {
    const nearest = largestThatFits(contour.slice(Math.max(0, i - 2), i + 3), side, radius);
    return issue("toolRadiusTooLarge", "error", { element: i + 1, radius, ...(nearest > 0 && { nearest }) }, "tool");
  });
  return { pieces, issues };
}
