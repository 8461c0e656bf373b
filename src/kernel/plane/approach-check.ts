import { approach, type Approach, type ApproachRequest } from "./approach.ts";
import { overlap, type Box } from "../geometry/segments.ts";
import { plane, type PlanePoint, type PlaneSegment, type Side } from "./plane.ts";
import { CHORD, SAME } from "../tolerance.ts";

const { apart, beyond, boxOf, cross, difference, distanceTo, flattenedChain, gapBetween, nearestOn, turned } = plane;

/** A place where the tool, in its full width, cuts into the contour on its approach or departure. */
export interface ContourCut {
  /** Depth of the tool beyond the contour, mm. */
  readonly depth: number;
  readonly on: PlanePoint;
}
/** The change that clears the path: another PS or PN, or another LEN or R. */
export type ApproachFix =
  | { readonly kind: "point"; readonly point: PlanePoint }
  | { readonly kind: "value"; readonly word: "LEN" | "R"; readonly value: number };

/** Smaller depths than a control can display are no cut, mm. */
const LEAST_CUT = 0.001;

/** Tells whether a point is on the material side of a closed contour; an open one has no inside. */
function materialOf(contour: readonly PlaneSegment[], side: Side): (p: PlanePoint) => boolean {
  const [first, last] = [contour[0], contour.at(-1)];
  if (!first || !last || contour.length < 2 || apart(first.from, last.to) > SAME) return () => false;
  const ring = flattenedChain(contour, CHORD);
  const area = ring.reduce((total, a, i) => total + cross(a, ring[(i + 1) % ring.length] ?? a), 0);
  return (p) => {
    let inside = false;
    ring.forEach((a, i) => {
      const b = ring[(i + 1) % ring.length] ?? a;
      if (a.y > p.y !== b.y > p.y && p.x < a.x + ((p.y - a.y) / (b.y - a.y)) * (b.x - a.x)) inside = !inside;
    });
    return (inside === area > 0) === (side === "right");
  };
}

function endsOf(legs: readonly PlaneSegment[]): PlanePoint[] {
  const [first, last] = [legs[0], legs.at(-1)];
  return first && last ? [first.from, last.to] : [];
}

const wider = (b: Box, by: number): Box => ({
  left: b.left - by,
  right: b.right + by,
  low: b.low - by,
  high: b.high + by,
});

/**
 * The deepest place where a tool on these legs cuts into the contour, given its free side; null when the path is free.
 */
export function contourCut(
  legs: readonly PlaneSegment[],
  contour: readonly PlaneSegment[],
  side: Side,
  toolRadius: number,
  inMaterial = materialOf(contour, side),
): ContourCut | null {
  if (side === "none") return null;
  let worst: ContourCut | null = null;
  const note = (depth: number, on: PlanePoint) => {
    if (depth > (worst?.depth ?? LEAST_CUT)) worst = { depth, on };
  };
  for (const leg of legs) {
    const box = wider(boxOf(leg), toolRadius);
    for (const s of contour) {
      if (!overlap(box, boxOf(s))) continue;
      const gap = gapBetween(leg, s);
      note(toolRadius - gap.distance, gap.on);
    }
  }
  // A path that does not touch the contour stays on one side, so checking its ends is enough.
  for (const end of endsOf(legs)) {
    if (contour.length === 0 || !inMaterial(end)) continue;
    const on = contour.map((s) => nearestOn(s, end)).reduce((a, b) => (apart(b, end) < apart(a, end) ? b : a));
    note(toolRadius + apart(on, end), on);
  }
  return worst;
}

/** Which legs of an approach run at the depth of the contour: all, or all but the one above the part. */
export type CheckedLegs = "all" | "fromPH";

const legsOf = (a: Approach, checked: CheckedLegs) =>
  a.legs
    .filter((l, i) => checked === "all" || a.departing || i > 0 || l.segment.to === a.points.PA)
    .map((l) => l.segment);

/** Rotations of PS about PH to try, nearest first, degrees; and factors of its distance. */
const TURNS = Array.from({ length: 18 }, (_, i) => [10 * (i + 1), -10 * (i + 1)]).flat();
const FACTORS = [1, 1.5, 2, 3];
/** Number of sizes to try for LEN and R: steps of half a millimetre to a sixth of the value. */
const STEPS = 60;

const onGrid = (n: number, grid: number) => Math.round(n / grid) * grid;

/**
 * Checks an approach or departure against the whole programmed contour, and looks for the nearest collision-free
 * variant. `contour` includes its roundings and chamfers; the control does not check PS→PH.
 */
export function checkApproach(
  q: ApproachRequest,
  contour: readonly PlaneSegment[],
  checked: CheckedLegs = "all",
): { readonly cut: ContourCut; readonly free: ApproachFix | null } | null {
  const made = approach(q);
  if (q.side === "none") return null;
  const inMaterial = materialOf(contour, q.side);
  const cut = contourCut(legsOf(made, checked), contour, q.side, q.toolRadius, inMaterial);
  if (!cut) return null;
  const near = nearby(q, made, contour);
  const isFree = (other: ApproachRequest) => {
    const tried = approach(other);
    const legs = legsOf(tried, checked);
    return (
      tried.issues.every((i) => i.severity !== "error") &&
      !contourCut(legs, near, q.side, q.toolRadius, () => false) &&
      !endsOf(legs).some(inMaterial)
    );
  };
  return { cut, free: freePoint(q, made, isFree) ?? freeValue(q, isFree) };
}

/** The part of a long contour within reach of the search. */
function nearby(q: ApproachRequest, made: Approach, contour: readonly PlaneSegment[]): readonly PlaneSegment[] {
  const at = made.points.PA ?? made.points.PE;
  if (!at) return contour;
  const reach =
    2 * q.toolRadius +
    4 * ((q.outside ? apart(q.outside, at) : 0) + 3 * Math.abs(q.length ?? 0) + 6 * Math.abs(q.radius ?? 0));
  return contour.filter((s) => distanceTo(s, at) <= reach);
}

function freePoint(q: ApproachRequest, made: Approach, isFree: (q: ApproachRequest) => boolean): ApproachFix | null {
  const pivot = made.points.PH ?? made.points.PA ?? made.points.PE;
  const { outside } = q;
  if (!outside || !pivot || (q.departing && q.shape !== "LCT")) return null;
  const tried = FACTORS.flatMap((k) =>
    [0, ...TURNS].map((angle) => {
      const p = turned(beyond(pivot, difference(outside, pivot), k), pivot, angle);
      return { x: onGrid(p.x, 0.5), y: onGrid(p.y, 0.5) };
    }),
  ).sort((a, b) => apart(a, outside) - apart(b, outside));
  const point = tried.find((p) => isFree({ ...q, outside: p }));
  return point ? { kind: "point", point } : null;
}

function freeValue(q: ApproachRequest, isFree: (q: ApproachRequest) => boolean): ApproachFix | null {
  const straight = q.shape === "LT" || q.shape === "LN";
  const size = Math.abs((straight ? q.length : q.radius) ?? 0);
  const step = Math.max(0.5, onGrid(size / 6, 0.5));
  for (let i = 1; i <= STEPS; i += 1) {
    for (const value of [onGrid(size - i * step, 0.5), onGrid(size + i * step, 0.5)]) {
      if (value > 0 && isFree(straight ? { ...q, length: value } : { ...q, radius: value }))
        return { kind: "value", word: straight ? "LEN" : "R", value };
    }
  }
  return null;
}
