import { issue, type Issue } from "../plan/issue.ts";
import { part, type Pt, type Segment } from "../geometry/point.ts";
import { findPlace } from "./solve-choose.ts";
import { findAngles, findCircles, travelDirection } from "./solve-curves.ts";
import { findTouches } from "./solve-touches.ts";
import { pointOf, solveCoordinates, startSolving, type SolveElement, type SolveState } from "./solve-work.ts";
import { ARC_END, SAME } from "../tolerance.ts";
import {
  axial,
  type Axial,
  degrees,
  type Degrees,
  inDegrees,
  length,
  type Length,
  radians,
  radius,
  type Radius,
  roundedAngle,
} from "../units.ts";

const { angleOf, apart, cross, difference, dot, heading } = part;

/** Result for one element of a contour. */
export interface SolvedElement {
  readonly z: Axial | null;
  readonly r: Radius | null;
  /** Number of missing values; 0 when the element is determined. */
  readonly freedom: number;
  /** Number of solutions to choose from. */
  readonly choices: number;
  /** Angle to +Z of a line, 0 to 360; null for arcs and where it is not known. */
  readonly angle: Degrees | null;
  readonly length: Length | null;
  readonly segment: Segment | null;
}

export interface SolvedContour {
  readonly elements: readonly SolvedElement[];
  /** Contradicting or unreachable values; `element` counts from 1. */
  readonly issues: readonly Issue[];
}

/** Directions of tangential elements may differ by this much, degrees: typed values are rounded. */
const TANGENT = 0.2;

/**
 * Finds the coordinates of a contour that follow from the given values: angles, lengths, tangential transitions, radii
 * and centres, forwards and backwards. Undetermined elements are reported one by one, contradictions as issues;
 * coordinates take precedence.
 */
export function solveContour(elements: readonly SolveElement[]): SolvedContour {
  const w = startSolving(elements);
  // Each round finds at least one coordinate, direction or circle.
  for (let round = 0; round <= elements.length * 4 + 4; round += 1) {
    const found = solveCoordinates(w);
    const bent = findAngles(w),
      circled = findCircles(w),
      touched = findTouches(w);
    if (found || bent || circled || touched) continue;
    if (!findPlace(w)) break;
  }
  const solved = elements.map((_, i) => solvedElement(w, i));
  return { elements: solved, issues: elements.flatMap((e, i) => contradictions(w, e, i, solved[i]?.freedom ?? 0)) };
}

const round = (angle: number): Degrees => {
  const n = Math.round(inDegrees(angle) * 1e6) / 1e6;
  return degrees(n < 0 ? (n + 360) % 360 : n % 360);
};

function solvedElement(w: SolveState, i: number): SolvedElement {
  const [z, r, segment] = [w.z[i] ?? null, w.r[i] ?? null, segmentOf(w, i)];
  const straight = w.elements[i]?.kind === "line",
    angle = w.angle[i] ?? null;
  return {
    z: z === null ? null : axial(z),
    r: r === null ? null : radius(r),
    segment,
    choices: w.choices[i] ?? 1,
    freedom: freedomOf(w, i, segment),
    angle: straight && angle !== null ? round(angle) : null,
    length: segment?.kind === "line" ? length(apart(segment.from, segment.to)) : null,
  };
}

function segmentOf(w: SolveState, i: number): Segment | null {
  const [from, to, circle] = [pointOf(w, i - 1), pointOf(w, i), w.circle[i] ?? null];
  if (i === 0 || !from || !to) return null;
  if (w.elements[i]?.kind === "line" || circle === "straight") return { kind: "line", from, to };
  return circle && { kind: "arc", from, to, centre: circle.centre, turn: circle.turn };
}

/**
 * Missing values of the end point that are not already missing at the point before it, less those that a length or a
 * circle determines; for an arc also those of its circle.
 */
function freedomOf(w: SolveState, i: number, segment: Segment | null): number {
  const e = w.elements[i],
    form = w.forms[i],
    before = w.forms[i - 1];
  if (pointOf(w, i)) return e?.kind === "arc" && i > 0 && !segment && pointOf(w, i - 1) ? 1 : 0;
  const counted = new Set(before ? [...before.z.by.keys(), ...before.r.by.keys()] : []);
  const free = form
    ? [...new Set([...form.z.by.keys(), ...form.r.by.keys()])].filter((k) => !counted.has(k)).length
    : 0;
  if (free === 0) return 0;
  const bound = [i, i + 1].filter((k) => {
    const other = w.elements[k],
      circle = w.circle[k] ?? null;
    if (circle && circle !== "straight") return true;
    return (
      k > 0 &&
      other?.kind === "line" &&
      other.length !== null &&
      (w.angle[k] ?? null) === null &&
      pointOf(w, k === i ? i - 1 : i + 1)
    );
  }).length;
  const own = form && (form.z.by.size === 0 || form.r.by.size === 0) ? 1 : Math.min(2, free);
  return Math.max(1, own - bound);
}

/** The angle between two directions, degrees. */
const between = (a: Pt, b: Pt) => Math.abs(inDegrees(Math.atan2(cross(a, b), dot(a, b))));

function contradictions(w: SolveState, e: SolveElement, i: number, freedom: number): Issue[] {
  const found: Issue[] = [],
    element = i + 1;
  const say = (quantity: "angle" | "length" | "tangent" | "radius", given: number, nearest: number) =>
    found.push(
      issue("elementContradicts", "error", { element, quantity, given, nearest: roundedAngle(nearest) }, "contour"),
    );
  const [from, to] = [pointOf(w, i - 1), pointOf(w, i)];
  if (freedom > 0 && !w.unreachable.has(i)) return [issue("elementFree", "error", { element, freedom }, "contour")];
  if (!to || freedom > 0)
    return w.unreachable.has(i) ? [issue("elementUnreachable", "error", { element }, "contour")] : [];
  if (!from || i === 0) return [];
  if (e.kind === "line") lineAgainst(e, from, to, say);
  const circle = w.circle[i] ?? null;
  if (e.kind === "arc" && circle && circle !== "straight") {
    const miss = Math.max(...[from, to].map((p) => Math.abs(apart(p, circle.centre) - circle.radius)));
    if (miss > ARC_END && !e.centre) say("radius", circle.radius, apart(from, circle.centre));
  }
  const [before, own] = [
    travelDirection(w, i - 1, i - 1),
    apart(from, to) > SAME ? travelDirection(w, i, i - 1) : null,
  ];
  if (e.tangent && i > 1 && before && own && between(before, own) > TANGENT) say("tangent", 0, between(before, own));
  return found;
}

function lineAgainst(
  e: Extract<SolveElement, { kind: "line" }>,
  from: Pt,
  to: Pt,
  say: (quantity: "angle" | "length", given: number, nearest: number) => void,
): void {
  const far = apart(from, to);
  if (far <= SAME) return;
  const real = angleOf(difference(to, from));
  const given = e.angle === null ? null : heading(radians(e.angle)),
    own = heading(real);
  if (given && e.angle !== null) {
    const off = Math.abs(cross(given, difference(to, from)));
    if (off > ARC_END || dot(given, own) < 0) say("angle", e.angle, round(real));
  }
  if (e.length !== null && Math.abs(far - e.length) > ARC_END) say("length", e.length, far);
}
