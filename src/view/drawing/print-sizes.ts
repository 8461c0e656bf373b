import { at, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import { diameter, type Diameter, toDiameter, toRadius } from "../../kernel/units.ts";
import { BESIDE, spanAt, type PrintThread } from "./body.ts";
import type { Limits } from "./measured-feature.ts";
import type { PrintSize } from "./paper.ts";
import type { PrintCorner, PrintFeatures } from "./print-features.ts";

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
export interface PrintWords {
  readonly diameter: (value: Diameter) => string;
  /** A length, or a radius or chamfer, without its sign. */
  readonly length: (value: number) => string;
  /** A place along the axis, with its sign. */
  readonly position: (value: number) => string;
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

/** Nearer values are one, mm. */
const ONE = 0.005;
/** A size belongs to a feature whose value is this near, mm. */
const BELONGS = 0.5;

/** A diameter with its stretch along Z, and the place of its dimension. */
export interface Across {
  readonly r: number;
  readonly left: number;
  readonly right: number;
  readonly isBore: boolean;
  readonly isBlank: boolean;
  readonly size: PrintSize;
  readonly limits: Limits;
}

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

/** Deviations of a diameter: those of a size within its stretch. */
const sizeAcross = (
  sizes: readonly TolerancedSize[],
  kind: "diameter" | "bore",
  r: number,
  stretch: { left: number; right: number },
) =>
  sizes.find(
    (s) =>
      s.kind === kind &&
      s.at >= stretch.left - ONE &&
      s.at <= stretch.right + ONE &&
      Math.abs(s.nominal - toDiameter(at(0, r).r)) < BELONGS,
  );

export function diametersOf(work: PrintedPart, features: PrintFeatures, isBore: boolean, words: PrintWords): Across[] {
  const kind = isBore ? "bore" : "diameter",
    made: Across[] = [];
  for (const { r, left, right, follows } of features.cylinders) {
    const found = sizeAcross(work.sizes, kind, r, { left, right });
    if (follows && !found) continue;
    const size = toleranced(words.diameter(found ? diameter(found.nominal) : toDiameter(at(0, r).r)), found, words);
    const limits = limitsOf(r, found, (value) => toRadius(diameter(value)));
    const same = made.find((m) => Math.abs(m.r - r) < ONE && spelled(m.size) === spelled(size));
    if (!same) made.push({ r, left, right, isBore, isBlank: false, size, limits });
    else if (right > same.right) made[made.indexOf(same)] = { ...same, right, left };
  }
  return made;
}

function cornerSize(corner: PrintCorner, words: PrintWords): string {
  if (corner.kind !== "chamfer") return words[corner.kind](corner.size);
  return corner.across === null ? words.chamfer(corner.size, corner.angle) : words.legs(corner.size, corner.across);
}

/** Corners of one size share one note, at the first of them from the free end, with their number. */
export function cornersOf(
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

/** Where a thread ends on its own surface, without an edge; not where it runs out in a groove. */
const runOut = (rings: readonly Ring[], { from, to }: PrintThread): readonly Pt[] =>
  [from, to].filter((p) => {
    const span = spanAt(rings, p.z);
    return span !== null && [span.high, span.low].some((r) => Math.abs(r - p.r) < ONE);
  });

/** The positions that need a length from Z0, with their deviations; `end` is the end of the part, if it is drawn. */
export function positionsOf(
  work: PrintedPart,
  features: readonly PrintFeatures[],
  words: PrintWords,
  end: number | null,
) {
  const made: { from: Pt; size: PrintSize; limits: Limits }[] = [];
  const all = [
    ...features.flatMap(({ positions }) => positions),
    ...work.threads.flatMap((thread) => runOut(work.rings, thread)),
  ];
  for (const p of all) {
    if (Math.abs(p.z) < ONE || made.some(({ from }) => Math.abs(from.z - p.z) < ONE)) continue;
    const found = work.sizes.find((s) => s.kind === "face" && Math.abs(s.nominal - p.z) < BELONGS && s.nominal !== 0);
    made.push({
      from: p,
      size: toleranced(words.length(Math.abs(found?.nominal ?? p.z)), found && outwards(found), words),
      limits: limitsOf(p.z, found, (z) => z),
    });
  }
  const last = spanAt(work.rings, (end ?? 0) + BESIDE);
  if (end !== null && last && !made.some(({ from }) => Math.abs(from.z - end) < ONE))
    made.push({ from: at(end, last.high), size: { text: `(${words.length(Math.abs(end))})` }, limits: [end, end] });
  return made;
}

/** Deviations of a Z as deviations of a length: behind Z0 a smaller Z is a greater length. */
const outwards = (size: TolerancedSize): TolerancedSize =>
  size.nominal < 0 ? { ...size, upper: 0 - size.lower, lower: 0 - size.upper } : size;

/** The surface marks: one for all turned surfaces, or each at the longest surface of its stretch. */
export function surfaceMarks(work: PrintedPart, outer: PrintFeatures, inner: PrintFeatures) {
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
