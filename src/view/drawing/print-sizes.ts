import { at, part, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import { diameter, type Diameter, toDiameter, toRadius } from "../../kernel/units.ts";
import { boxAround } from "../../kernel/area/box.ts";
import type { Bounds } from "../camera.ts";
import { BESIDE, spanAt, type PrintThread } from "./body.ts";
import { featuresOnPart, type FoundCylinder, type FoundPosition, type TurnedContour } from "./found-features.ts";
import type { Limits, MeasuredFeature } from "./measured-feature.ts";
import type { PrintSize } from "./paper.ts";
import { printFeatures, type PrintCorner, type PrintFeatures } from "./print-features.ts";

/**
 * A size with deviations. "diameter" outside and "bore" inside at Z = at; "face": the first material from the free end
 * at ⌀ = at. mm.
 */
export interface TolerancedSize {
  readonly kind: "diameter" | "bore" | "face";
  readonly at: number;
  readonly nominal: number;
  readonly upper: number;
  readonly lower: number;
}

/** What is drawn. Part space, mm. */
export interface PrintedPart {
  readonly blank: readonly Ring[];
  readonly rings: readonly Ring[];
  readonly outside: readonly Segment[];
  readonly bore: readonly Segment[];
  readonly sizes: readonly TolerancedSize[];
  readonly threads: readonly PrintThread[];
  /** Greatest Rz between two Z, µm. */
  readonly marks: readonly { readonly from: number; readonly to: number; readonly most: number }[];
}

/** Numbers as the drawing's language writes them. */
interface SizeWords {
  readonly diameter: (value: Diameter) => string;
  /** A length, or a radius or chamfer, without its sign. */
  readonly length: (value: number) => string;
  /** A place along the axis, with its sign. */
  readonly position: (value: number) => string;
}

/** The same with all that only a part in the making has. */
export interface PrintWords extends SizeWords {
  /** A deviation with its sign, and one that is the same on both sides. */
  readonly deviation: (value: number) => string;
  readonly both: (value: number) => string;
  readonly radius: (value: number) => string;
  readonly chamfer: (size: number, angle: number) => string;
  /** A chamfer by its two legs: along the axis, and along the face. */
  readonly legs: (axial: number, across: number) => string;
  /** Degrees. */
  readonly angle: (value: number) => string;
  readonly roughness: (value: number) => string;
}

/** The same with threads by their lead, as a set-up states them. */
export interface SetUpWords extends SizeWords {
  readonly thread: (diameter: string, lead: number, starts: number) => string;
}

/** A size of the drawing as data, for a list beside it. */
export interface ListedSize {
  readonly kind: "diameter" | "bore" | "length" | "chamfer" | "radius" | "angle" | "thread" | "mark" | "blank";
  readonly size: PrintSize;
  /** Z of its place, both ends of a stretch; mm. */
  readonly at: readonly number[];
  /** What it measures on the part; null for the blank, threads and surface marks. */
  readonly measures: MeasuredFeature | null;
}

/** A note with the place that its leader shows; a surface mark has a symbol. */
export interface Note {
  readonly size: PrintSize;
  readonly at: Pt;
  readonly isMark: boolean;
}

/** Nearer values are one, mm. */
const ONE = 0.005;
/** A size belongs to a feature whose value is this near, mm. */
const BELONGS = 0.5;

/** A size as it is written, and what it allows. */
interface Sized {
  readonly size: PrintSize;
  readonly limits: Limits;
}

/** A diameter with its stretch along Z; `extent`: the length of its surfaces, mm. */
export interface Across extends Sized {
  readonly r: number;
  readonly left: number;
  readonly right: number;
  readonly isBore: boolean;
  readonly isBlank: boolean;
  readonly extent: number;
}

/** A position along the axis; `extent`: the length of its faces, mm. */
export interface Position extends FoundPosition, Sized {}

function toleranced(text: string, found: TolerancedSize | undefined, words: PrintWords): PrintSize {
  if (!found || (found.upper === 0 && found.lower === 0)) return { text };
  if (Math.abs(found.upper + found.lower) < ONE / 10) return { text: `${text}${words.both(found.upper)}` };
  return { text, upper: words.deviation(found.upper), lower: words.deviation(found.lower) };
}

function limitsOf(drawn: number, found: TolerancedSize | undefined, measured: (value: number) => number): Limits {
  const all = [drawn, ...(found ? [found.lower, found.upper].map((by) => measured(found.nominal + by)) : [])];
  return [Math.min(...all), Math.max(...all)];
}

const spelled = ({ text, upper = "", lower = "" }: PrintSize) => [text, upper, lower].join(" ");

const isPlain = ({ limits: [least, most] }: Sized) => least === most;

/** The diameters of cylinders, each once with its deviations; those without a size of their own are left out. */
function diametersOf(cylinders: readonly FoundCylinder[], sized: (own: FoundCylinder) => Sized | null): Across[] {
  const made: Across[] = [];
  for (const own of cylinders) {
    const size = sized(own);
    if (!size) continue;
    const { r, left, right, isBore, extent } = own;
    const isSame = (m: Across) =>
      m.isBore === isBore &&
      Math.abs(m.r - r) < ONE &&
      (spelled(m.size) === spelled(size.size) || (isPlain(m) && isPlain(size)));
    const i = made.findIndex(isSame),
      known = made[i];
    if (!known) made.push({ r, left, right, isBore, isBlank: false, extent, ...size });
    else made[i] = { ...known, ...(right > known.right && { left, right }), extent: known.extent + extent };
  }
  return made;
}

/** The positions, each once, where its line is shortest. */
function positionsOf(positions: readonly FoundPosition[], sized: (z: number) => Sized): Position[] {
  const made: Position[] = [];
  for (const { from, extent } of positions) {
    const i = made.findIndex((m) => Math.abs(m.from.z - from.z) < ONE),
      known = made[i];
    if (!known) made.push({ from, extent, ...sized(from.z) });
    else made[i] = { ...known, extent: known.extent + extent, from: known.from.r >= from.r ? known.from : from };
  }
  return made;
}

/** The diameters of the blank that are not also diameters of the part, on the stretch that each keeps. */
function acrossBlank(
  blank: Bounds,
  turned: readonly Across[],
  words: SizeWords,
  stretch: (isBore: boolean) => readonly [left: number, right: number],
): Across[] {
  return [false, true].flatMap((isBore): Across[] => {
    const r = isBore ? blank.low : blank.high,
      [left, right] = stretch(isBore);
    if (r < ONE || right < left + ONE || turned.some((t) => t.isBore === isBore && Math.abs(t.r - r) < ONE)) return [];
    const size = { text: `(${words.diameter(toDiameter(at(0, r).r))})` };
    return [{ r, left, right, isBore, isBlank: true, extent: Infinity, size, limits: [r, r] }];
  });
}

function cornerSize(corner: PrintCorner, words: PrintWords): string {
  if (corner.kind !== "chamfer") return words[corner.kind](corner.size);
  return corner.across === null ? words.chamfer(corner.size, corner.angle) : words.legs(corner.size, corner.across);
}

/** Corners of one size share one note, at the first of them from the free end, with their number. */
function cornersOf(
  corners: readonly PrintCorner[],
  words: PrintWords,
): { readonly corner: PrintCorner; readonly size: PrintSize; readonly all: readonly Pt[] }[] {
  const made = new Map<string, { corner: PrintCorner; all: Pt[] }>();
  for (const corner of [...corners].sort((a, b) => b.at.z - a.at.z)) {
    const text = cornerSize(corner, words),
      known = made.get(text);
    if (known) known.all.push(corner.at);
    else made.set(text, { corner, all: [corner.at] });
  }
  return [...made].map(([text, { corner, all }]) => ({
    corner,
    all,
    size: { text: all.length > 1 ? `${all.length}× ${text}` : text },
  }));
}

/** Positions with the ends of the material, in brackets, that are not among them. */
const withEnds = (made: readonly Position[], ends: readonly Pt[], text: (z: number) => string): Position[] => [
  ...made,
  ...ends
    .filter(({ z }) => !made.some((m) => Math.abs(m.from.z - z) < ONE))
    .map((from): Position => ({
      from,
      extent: Infinity,
      size: { text: `(${text(from.z)})` },
      limits: [from.z, from.z],
    })),
];

/** Where a thread ends on its own surface, without an edge; not where it runs out in a groove. */
const runOut = (rings: readonly Ring[], { from, to }: PrintThread): readonly Pt[] =>
  [from, to].filter((p) => {
    const span = spanAt(rings, p.z);
    return span !== null && [span.high, span.low].some((r) => Math.abs(r - p.r) < ONE);
  });

/** Deviations of a Z as deviations of a length: behind Z0 a smaller Z is a greater length. */
const outwards = (size: TolerancedSize): TolerancedSize =>
  size.nominal < 0 ? { ...size, upper: 0 - size.lower, lower: 0 - size.upper } : size;

/** The surface marks: one for all turned surfaces, or each at the longest surface of its stretch. */
function surfaceMarks(work: PrintedPart, outer: PrintFeatures, inner: PrintFeatures) {
  const turned = [...work.outside, ...work.bore].flatMap((s) => [s.from.z, s.to.z]);
  const [low, high] = [Math.min(...turned), Math.max(...turned)];
  let general: number | null = null;
  const single: { at: Pt; most: number; stretch: readonly number[] }[] = [];
  for (const { from, to, most } of work.marks) {
    const [a, b] = [Math.min(from, to), Math.max(from, to)];
    if (a <= low + ONE && b >= high - ONE && work.marks.length === 1) general = most;
    else {
      const within = [...outer.cylinders, ...inner.cylinders].map((c) => ({
        ...c,
        left: Math.max(c.left, a),
        right: Math.min(c.right, b),
      }));
      const best = within.sort((c, d) => d.right - d.left - (c.right - c.left))[0];
      if (best && best.right >= best.left)
        single.push({ at: at(best.left + (best.right - best.left) * 0.3, best.r), most, stretch: [b, a] });
    }
  }
  return { general, single };
}

const found = (features: PrintFeatures, isBore: boolean) =>
  features.cylinders.map((own): FoundCylinder => ({ ...own, isBore, extent: own.right - own.left }));

/**
 * All sizes that a part is made by: with deviations, lengths from Z0, broken edges, threads by name and surface marks.
 * `from`: where the drawn part begins; `isBroken`: whether the blank continues there.
 */
export function makerSizes(
  work: PrintedPart,
  words: PrintWords,
  { from, isBroken }: { readonly from: number; readonly isBroken: boolean },
) {
  const [outer, inner] = [printFeatures(work.outside), printFeatures(work.bore)];
  const turned = diametersOf([...found(outer, false), ...found(inner, true)], ({ r, left, right, follows, isBore }) => {
    const kind = isBore ? "bore" : "diameter",
      isOn = (s: TolerancedSize) => s.kind === kind && s.at >= left - ONE && s.at <= right + ONE;
    const own = work.sizes.find((s) => isOn(s) && Math.abs(s.nominal - toDiameter(at(0, r).r)) < BELONGS);
    if (follows && !own) return null;
    return {
      size: toleranced(words.diameter(own ? diameter(own.nominal) : toDiameter(at(0, r).r)), own, words),
      limits: limitsOf(r, own, (value) => toRadius(diameter(value))),
    };
  });
  const blank = boxAround([...work.blank]);
  const across = [
    ...turned,
    ...acrossBlank(blank, turned, words, (isBore) => [
      from,
      Math.min(blank.right, ...(isBore ? work.bore : work.outside).flatMap((s) => [s.from.z, s.to.z])),
    ]),
  ];
  const end = spanAt(work.rings, from + BESIDE);
  const positions = withEnds(
    positionsOf(
      [...outer.positions, ...inner.positions, ...work.threads.flatMap((thread) => runOut(work.rings, thread))]
        .filter(({ z }) => Math.abs(z) >= ONE)
        .map((p) => ({ from: p, extent: Infinity })),
      (z) => {
        const own = work.sizes.find((s) => s.kind === "face" && Math.abs(s.nominal - z) < BELONGS && s.nominal !== 0);
        return {
          size: toleranced(words.length(Math.abs(own?.nominal ?? z)), own && outwards(own), words),
          limits: limitsOf(z, own, (value) => value),
        };
      },
    ),
    end && !isBroken ? [at(from, end.high)] : [],
    (z) => words.length(Math.abs(z)),
  );
  const threads = work.threads.map((thread) => ({ thread, size: { text: thread.name } }));
  const corners = [...cornersOf(outer.corners, words), ...cornersOf(inner.corners, words)];
  const marks = surfaceMarks(work, outer, inner),
    single = marks.single.map((mark) => ({ ...mark, size: { text: words.roughness(mark.most) } }));
  const onThread = ({ r, left, right }: Across) =>
    work.threads.some(
      (t) => Math.abs(t.from.r - r) < ONE && [t.from.z, t.to.z].some((z) => z > left - ONE && z < right + 1),
    );
  const note = (size: PrintSize, p: Pt, isMark = false): Note => ({ size, at: p, isMark });
  const listed = (
    kind: ListedSize["kind"],
    size: PrintSize,
    zs: readonly number[],
    measures: MeasuredFeature | null = null,
  ): ListedSize => ({ kind, size, at: zs, measures });
  return {
    across: across.filter((a) => !onThread(a)),
    positions,
    notes: [
      ...threads.map(({ thread, size }) => note(size, part.pointOn(part.line(thread.from, thread.to), 1 / 2))),
      ...corners.map(({ corner, size }) => note(size, corner.at)),
      ...single.map((mark) => note(mark.size, mark.at, true)),
    ],
    list: [
      ...across.map(({ size, r, limits, isBore, isBlank, left, right }) => {
        const zs = left === right ? [left] : [right, left];
        if (isBlank) return listed("blank", size, zs);
        return listed(isBore ? "bore" : "diameter", size, zs, { kind: "diameter", r, left, right, limits });
      }),
      ...threads.map(({ thread, size }) => listed("thread", size, [thread.from.z, thread.to.z])),
      ...positions.map(({ size, from: { z }, limits }) => listed("length", size, [z], { kind: "length", z, limits })),
      ...corners.map(({ corner: { kind, size: own }, size, all: places }) => {
        const measures =
          kind === "angle" ? { kind, degrees: own, places } : { kind: "corner" as const, size: own, places };
        return listed(
          kind,
          size,
          places.map(({ z }) => z),
          measures,
        );
      }),
      ...single.map(({ size, stretch }) => listed("mark", size, stretch)),
    ],
    general: marks.general === null ? null : words.roughness(marks.general),
  };
}

/** Nearer along the axis is one place, mm. */
export const ONE_PLACE = 0.05;

/** The main sizes of what a set-up turns, as coordinates from its zero, and those of its blank in brackets. */
export function setterSizes(
  contours: readonly TurnedContour[],
  finished: readonly Ring[],
  blank: readonly Ring[],
  words: SetUpWords,
) {
  const { cylinders, positions } = featuresOnPart(contours, finished, blank);
  const turned = diametersOf(cylinders, ({ r, isBore }) => {
    const thread = cylinders.findLast((c) => c.isBore === isBore && Math.abs(c.r - r) < ONE && c.thread)?.thread;
    const text = words.diameter(toDiameter(at(0, r).r));
    return { size: { text: thread ? words.thread(text, thread.lead, thread.starts) : text }, limits: [r, r] };
  });
  const material = boxAround([...blank]);
  const ends = blank.length > 0 ? [at(material.left, material.high), at(material.right, material.high)] : [];
  const sized = (z: number): Sized => ({ size: { text: words.position(z) }, limits: [z, z] });
  const along = withEnds(positionsOf(positions, sized), ends, words.position);
  const zero = { from: at(0, 0), extent: Infinity, ...sized(0) };
  // Of two places that cannot be told apart, as of a slope, the first is shown.
  const outermost = (a: Pt, b: Pt) => b.z + b.r - a.z - a.r;
  return {
    across: [
      ...turned.toSorted((a, b) => outermost(at(a.right, a.r), at(b.right, b.r))),
      ...acrossBlank(material, turned, words, () => [material.left, material.right]),
    ],
    positions: (along.some(({ from: { z } }) => Math.abs(z) < ONE_PLACE) ? along : [zero, ...along]).toSorted((a, b) =>
      outermost(a.from, b.from),
    ),
  };
}
