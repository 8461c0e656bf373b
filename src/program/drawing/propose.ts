import { part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { ROUND } from "../../kernel/tolerance.ts";
import type { ContourChoice, Drawing, DrawnContour } from "./drawing.ts";
import { drawnContour } from "./contour-of.ts";

/** Choice for a drawing of which nothing is known. */
export const PLAIN_CHOICE: ContourChoice = {
  axis: "x",
  axisAt: 0,
  zero: 0,
  mirrored: false,
  half: "upper",
  diameters: false,
  piece: 0,
  side: "outside",
  gap: 0.01,
  reversed: false,
  thin: false,
  withoutLayers: [],
};
/** A tolerance that is proposed where the finer one leaves the contour in pieces, mm. */
const WIDER_GAP = 0.1;
/** Places nearer than this are one, mm. */
const SAME_PLACE = 0.01;
/** Most lines of one length and place that are compared in pairs. */
const MOST_ALIKE = 40;
/** Places tried of each direction. */
const TRIED = 6;

/** What speaks for an axis; the sum decides. Chosen so that a centre line wins, then symmetry, then the origin. */
const WEIGHTS = {
  centreLine: 3,
  symmetry: 4,
  oneSided: 1.5,
  lineOnAxis: 1.2,
  zeroAtEnd: 0.4,
  upperSide: 0.2,
  horizontal: 0.4,
};

/** A curve along a direction: its place along and across it. */
interface Along {
  readonly from: number;
  readonly to: number;
  readonly low: number;
  readonly high: number;
  readonly length: number;
  readonly kind: Segment["kind"];
}

function alongOf(s: Segment, axis: "x" | "y"): Along {
  const b = part.boxOf(s),
    common = { length: part.lengthOf(s), kind: s.kind };
  return axis === "x"
    ? { ...common, from: b.left, to: b.right, low: b.low, high: b.high }
    : { ...common, from: b.low, to: b.high, low: b.left, high: b.right };
}

const key = (n: number) => Math.round(n / SAME_PLACE);

/** Places about which lines are mirrored, with the share of all lines that are. */
function symmetries(all: readonly Along[]): Map<number, number> {
  const groups = new Map<string, Along[]>(),
    total = all.reduce((sum, c) => sum + c.length, 0) || 1,
    found = new Map<number, number>();
  const vote = (at: number, length: number) => found.set(key(at), (found.get(key(at)) ?? 0) + length / total);
  for (const c of all) {
    const name = `${c.kind} ${key(c.from)} ${key(c.to)} ${key(c.high - c.low)}`,
      there = groups.get(name);
    if (there) there.push(c);
    else groups.set(name, [c]);
  }
  for (const group of groups.values())
    group.slice(0, MOST_ALIKE).forEach((a, i, some) => {
      // A line across the axis is its own mirror image; one along it is not.
      if (a.high - a.low > SAME_PLACE) vote((a.low + a.high) / 2, a.length);
      for (const b of some.slice(i + 1))
        if (Math.abs(a.low - b.low) > SAME_PLACE) vote((a.low + b.high) / 2, a.length + b.length);
    });
  return new Map([...found].toSorted((a, b) => b[1] - a[1]).slice(0, TRIED));
}

interface Candidate {
  readonly axis: "x" | "y";
  readonly at: number;
  readonly score: number;
}

function candidates(drawing: Drawing, axis: "x" | "y"): Candidate[] {
  const outline = drawing.curves.filter((c) => c.role === "outline").map((c) => alongOf(c.segment, axis)),
    centres = drawing.curves
      .filter((c) => c.role === "centre" && c.segment.kind === "line")
      .map((c) => alongOf(c.segment, axis))
      .filter((c) => c.high - c.low < SAME_PLACE);
  const longest = drawing.curves.reduce(
    (most, c) => (c.role === "centre" && c.segment.kind === "line" ? Math.max(most, part.lengthOf(c.segment)) : most),
    0,
  );
  const low = outline.reduce((least, c) => Math.min(least, c.low), Infinity),
    high = outline.reduce((most, c) => Math.max(most, c.high), -Infinity),
    [from, to] = [
      outline.reduce((l, c) => Math.min(l, c.from), Infinity),
      outline.reduce((m, c) => Math.max(m, c.to), -Infinity),
    ];
  const mirrored = symmetries(outline);
  const places = new Map<number, number>();
  for (const at of [0, low, high, ...centres.map((c) => c.low), ...[...mirrored.keys()].map((k) => k * SAME_PLACE)])
    if (!places.has(key(at))) places.set(key(at), at);
  return [...places.values()].map((at) => {
    const isCentre = centres.filter((c) => Math.abs(c.low - at) < SAME_PLACE),
      isOneSided = low >= at - SAME_PLACE || high <= at + SAME_PLACE,
      onAxis = outline.filter((c) => c.high - c.low < SAME_PLACE && Math.abs(c.low - at) < SAME_PLACE),
      span = onAxis.reduce((sum, c) => sum + c.to - c.from, 0) / (to - from || 1),
      share = mirrored.get(key(at)) ?? 0;
    const score =
      (WEIGHTS.centreLine * isCentre.reduce((most, c) => Math.max(most, c.to - c.from), 0)) / (longest || 1) +
      (share > 0.5 ? WEIGHTS.symmetry * Math.min(1, share) : 0) +
      (isOneSided && at === 0 ? WEIGHTS.oneSided : 0) +
      (isOneSided ? WEIGHTS.lineOnAxis * Math.min(1, span) : 0) +
      (at === 0 && Math.abs(to) < SAME_PLACE ? WEIGHTS.zeroAtEnd : 0) +
      (at === 0 && low >= -SAME_PLACE ? WEIGHTS.upperSide : 0) +
      (axis === "x" ? WEIGHTS.horizontal : 0);
    return { axis, at, score };
  });
}

const reach = (made: DrawnContour) => {
  const ends = made.segments.flatMap((s) => [s.from, s.to]),
    zs = ends.map((p) => p.z);
  return zs.length === 0 ? 0 : Math.max(...zs) - Math.min(...zs);
};
const sizeOf = (made: DrawnContour) => made.segments.reduce((sum, s) => sum + part.lengthOf(s), 0);

/** Whether radii never fall along a contour. */
const rises = (points: readonly Pt[]) =>
  points.every((p, i) => p.r >= (points[i - 1]?.r ?? 0) - SAME_PLACE) &&
  (points.at(-1)?.r ?? 0) > (points[0]?.r ?? 0) + SAME_PLACE;

/**
 * The likeliest choice for a drawing: the axis by a centre line, by symmetry or at the origin, the half with more lines,
 * Z0 at the right or upper end, and a gap that joins the contour. What is given stays as given.
 */
export function propose(drawing: Drawing, given: Partial<ContourChoice> = {}): ContourChoice {
  const places = [...candidates(drawing, "x"), ...candidates(drawing, "y")].filter(
    (c) => Number.isFinite(c.at) && c.axis === (given.axis ?? c.axis),
  );
  const best = places.reduce<Candidate | null>((most, c) => (!most || c.score > most.score + ROUND ? c : most), null);
  if (!best) return { ...PLAIN_CHOICE, ...given };
  let choice: ContourChoice = {
    ...PLAIN_CHOICE,
    axis: best.axis,
    axisAt: Math.abs(best.at) < ROUND ? 0 : best.at,
    ...given,
  };
  if (given.half === undefined) {
    const [upper, lower] = (["upper", "lower"] as const).map((half) =>
      sizeOf(drawnContour(drawing, { ...choice, half })),
    );
    if ((lower ?? 0) > 1.05 * (upper ?? 0)) choice = { ...choice, half: "lower" };
  }
  let made = drawnContour(drawing, choice);
  if (given.gap === undefined) {
    const wide = drawnContour(drawing, { ...choice, gap: WIDER_GAP });
    if (reach(wide) > 1.1 * reach(made)) {
      choice = { ...choice, gap: WIDER_GAP };
      made = wide;
    }
  }
  const points = made.segments.flatMap((s) => [s.from, s.to]);
  return points.length === 0 || given.zero !== undefined ? choice : { ...choice, ...zeroOf(points, choice, given) };
}

/** Place of Z0, and the direction of Z where it was not given: the face is at the right end, or at the origin. */
function zeroOf(
  points: readonly Pt[],
  { zero, mirrored }: ContourChoice,
  given: Partial<ContourChoice>,
): Pick<ContourChoice, "zero" | "mirrored"> {
  const zs = points.map((p) => p.z),
    [left, right] = [Math.min(...zs), Math.max(...zs)];
  // Drawn from the origin to the right with its thick end there: the face is at the origin.
  const isFromOrigin = Math.abs(left) < SAME_PLACE && right > SAME_PLACE;
  if (given.mirrored === undefined && isFromOrigin && rises(points.toReversed()) && points.length > 2)
    return { mirrored: true, zero: 0 };
  const isZeroNear = right >= -SAME_PLACE && right <= 0.1 * (right - left);
  return { mirrored, zero: isZeroNear ? zero : mirrored ? zero - right : zero + right };
}
