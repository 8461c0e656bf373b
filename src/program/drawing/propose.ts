import { part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { ROUND } from "../../kernel/tolerance.ts";
import type { ContourChoice, Drawing, DrawnContour, LineRole } from "./drawing.ts";
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
  pairApart: 1,
  oneSided: 1.5,
  lineOnAxis: 1.2,
  halfSection: 1.2,
  zeroAtEnd: 2.5,
  openEnds: 1,
  upperSide: 0.2,
  horizontal: 0.4,
};
/** A part farther from the origin than this many times its own height is drawn anywhere: the origin is no axis. */
const FAR_OFF = 10;
/** Long lines, as those of a frame, count no more than this many times the middle length. */
const LONGEST_COUNTS = 3;

/** A curve along a direction: its place along and across it. */
interface Along {
  readonly from: number;
  readonly to: number;
  readonly low: number;
  readonly high: number;
  readonly weight: number;
  readonly kind: Segment["kind"];
  /** Mirrored about its middle it is the same. */
  readonly isOwnImage: boolean;
}

const near = (a: number, b: number) => Math.abs(a - b) < SAME_PLACE;

function alongOf(s: Segment, axis: "x" | "y"): Along {
  const b = part.boxOf(s),
    place = (p: Pt) => (axis === "x" ? { along: p.z, across: p.r } : { along: p.r, across: p.z }),
    [from, to] = [place(s.from), place(s.to)],
    middle = (from.across + to.across) / 2,
    isOwnImage = near(from.along, to.along) && (s.kind === "line" || near(place(s.centre).across, middle));
  const common = { weight: part.lengthOf(s), kind: s.kind, isOwnImage };
  return axis === "x"
    ? { ...common, from: b.left, to: b.right, low: b.low, high: b.high }
    : { ...common, from: b.low, to: b.high, low: b.left, high: b.right };
}

/** The curves with weights by their lengths, those of very long ones limited. */
function weighted(all: readonly Along[]): Along[] {
  const middle = all.map((c) => c.weight).toSorted((a, b) => a - b)[all.length >> 1] ?? 0;
  return all.map((c) => ({ ...c, weight: Math.min(c.weight, LONGEST_COUNTS * middle) }));
}

const key = (n: number) => Math.round(n / SAME_PLACE);

/** Curves that could be images of each other about a line along the direction. */
function groupsOf(all: readonly Along[]): Along[][] {
  const groups = new Map<string, Along[]>();
  for (const c of all) {
    const name = `${c.kind} ${key(c.from)} ${key(c.to)}`,
      there = groups.get(name);
    if (!there) groups.set(name, [c]);
    else if (there.length < MOST_ALIKE) there.push(c);
  }
  return [...groups.values()];
}

/** Places about which many curves are mirrored, the likeliest first. */
function symmetries(groups: readonly (readonly Along[])[]): number[] {
  const found = new Map<number, { at: number; weight: number }>();
  const vote = (at: number, weight: number) =>
    found.set(key(at), { at, weight: (found.get(key(at))?.weight ?? 0) + weight });
  for (const group of groups)
    group.forEach((a, i) => {
      if (a.isOwnImage) vote((a.low + a.high) / 2, a.weight);
      for (const b of group.slice(i + 1))
        if (!near(a.low, b.low) && near(a.high - a.low, b.high - b.low))
          vote((a.low + b.high) / 2, a.weight + b.weight);
    });
  const best = [...found.values()].toSorted((a, b) => b.weight - a.weight);
  return best.slice(0, TRIED).map(({ at }) => at);
}

/** A symmetry needs pairs: at least this share; a line across the axis is always its own image. */
const LEAST_PAIRED = 0.2;

/** Share of the curves in a range along a line that have their mirror image across it. */
function mirroredShare(groups: readonly (readonly Along[])[], at: number, from: number, to: number): number {
  let [all, paired, own] = [0, 0, 0];
  for (const group of groups)
    for (const c of group) {
      if (c.from < from - SAME_PLACE || c.to > to + SAME_PLACE) continue;
      all += c.weight;
      const image = (o: Along) => near(o.low, 2 * at - c.high) && near(o.high, 2 * at - c.low);
      if (!near((c.low + c.high) / 2, at)) paired += group.some((o) => o !== c && image(o)) ? c.weight : 0;
      else if (c.isOwnImage) own += c.weight;
    }
  return paired > LEAST_PAIRED * all ? (paired + own) / all : 0;
}

/** Points in which only one curve ends. */
function looseEnds(segments: readonly Segment[]): readonly Pt[] {
  const found = new Map<string, Pt | null>();
  for (const p of segments.flatMap((s) => [s.from, s.to])) {
    const name = `${key(p.z)} ${key(p.r)}`;
    found.set(name, found.has(name) ? null : p);
  }
  return [...found.values()].filter((p) => p !== null);
}

interface Candidate {
  readonly axis: "x" | "y";
  readonly at: number;
  readonly score: number;
}

function candidates(drawing: Drawing, axis: "x" | "y"): Candidate[] {
  const of = (role: LineRole) => drawing.curves.filter((c) => c.role === role).map((c) => c.segment);
  const outline = weighted(of("outline").map((s) => alongOf(s, axis))),
    centreLines = of("centre").filter((s) => s.kind === "line"),
    longest = centreLines.reduce((most, s) => Math.max(most, part.lengthOf(s)), 0),
    centres = centreLines.map((s) => alongOf(s, axis)).filter((c) => near(c.low, c.high));
  const least = (place: (c: Along) => number) => outline.reduce((l, c) => Math.min(l, place(c)), Infinity),
    most = (place: (c: Along) => number) => outline.reduce((m, c) => Math.max(m, place(c)), -Infinity),
    [low, high, from, to] = [least((c) => c.low), most((c) => c.high), least((c) => c.from), most((c) => c.to)];
  const isFarOff = Math.max(low, -high) > FAR_OFF * (high - low),
    ends = looseEnds(of("outline")).map((p) => (axis === "x" ? p.r : p.z));
  const groups = groupsOf(outline),
    places = new Map<number, number>();
  for (const at of [0, low, high, ...centres.map((c) => c.low), ...symmetries(groups)])
    if (!places.has(key(at))) places.set(key(at), at);
  return [...places.values()].map((at) => {
    const centre = centres
        .filter((c) => near(c.low, at))
        .reduce<Along | null>((most, c) => (most && most.to - most.from >= c.to - c.from ? most : c), null),
      share = mirroredShare(groups, at, centre?.from ?? -Infinity, centre?.to ?? Infinity),
      // Pieces that are images of each other, with nothing between them: the section of a ring.
      isPairApart = share > 0.5 && !outline.some((c) => c.low < at + SAME_PLACE && c.high > at - SAME_PLACE),
      isOneSided = low >= at - SAME_PLACE || high <= at + SAME_PLACE,
      onAxis = outline.filter((c) => near(c.low, c.high) && near(c.low, at)),
      span = Math.min(1, onAxis.reduce((sum, c) => sum + c.to - c.from, 0) / (to - from || 1));
    const score =
      (centre ? (WEIGHTS.centreLine * (centre.to - centre.from)) / (longest || 1) : 0) +
      (share > 0.5 ? WEIGHTS.symmetry * share : 0) +
      (isPairApart ? WEIGHTS.pairApart * share : 0) +
      (isOneSided && at === 0 && !isFarOff ? WEIGHTS.oneSided : 0) +
      (isOneSided && span === 0 && ends.filter((place) => near(place, at)).length > 1 ? WEIGHTS.openEnds : 0) +
      (isOneSided ? WEIGHTS.lineOnAxis * span : 0) +
      (isOneSided && at === 0 && span > 0.9 ? WEIGHTS.halfSection : 0) +
      (isOneSided && at === 0 && near(to, 0) ? WEIGHTS.zeroAtEnd : 0) +
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
