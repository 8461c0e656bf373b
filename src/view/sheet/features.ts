import { boxAround } from "../../kernel/area/box.ts";
import { isInside } from "../../kernel/area/clip.ts";
import { at, part, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import { printFeatures } from "../drawing/print-features.ts";

/** A diameter of the finished part: the point where its line begins, and whether there is material inside. */
export interface DiameterFeature {
  readonly at: Pt;
  readonly outside: boolean;
  /** It belongs to the blank. */
  readonly ofBlank?: true;
  /** What a thread adds to it. */
  readonly thread?: { readonly lead: number; readonly starts: number };
  /** Length of the part with this diameter, mm: the shortest are left out first. */
  readonly extent: number;
}

/** A position along the axis: a shoulder, the side of a groove, the end of a cone. */
export interface PositionFeature {
  readonly at: Pt;
  readonly ofBlank?: true;
  readonly extent: number;
}

export interface Features {
  readonly diameters: readonly DiameterFeature[];
  readonly positions: readonly PositionFeature[];
}

/** One contour that the program turns, with the thread that it carries. */
export interface TurnedContour {
  readonly segments: readonly Segment[];
  readonly thread?: { readonly lead: number; readonly starts: number };
}

/** Nearer values are one dimension, mm. */
const ONE = 0.005;
/** Straight along an axis within this, mm. */
const LEVEL = 0.001;
/** A contour this near to the part is a contour of the finished part: oversize may still be on it, mm. */
const NEAR = 0.8;
/** Offset of the probes for material on either side of a surface, mm. */
const ASIDE = 1;
/**
 * Cones and arcs shorter than this share of the part's size are broken edges, not features; nor are shorter sides of
 * grooves, which leave their axis by less than a share of their length.
 */
const SHORT = 0.05,
  SIDE = { share: 0.02, steep: 0.27 } as const;

const inMaterial = (rings: readonly Ring[], p: Pt): boolean =>
  rings.filter((ring) => isInside(ring, p)).length % 2 === 1;

function edgesOf(rings: readonly Ring[]): readonly Segment[] {
  return rings.flatMap((ring) =>
    ring.map((from, i): Segment => ({ kind: "line", from, to: ring[(i + 1) % ring.length] ?? from })),
  );
}

/** Whether an element counts on a part of a size: the others are broken edges. */
function isShown(segment: Segment, size: number): boolean {
  const [long, tall] = [Math.abs(segment.to.z - segment.from.z), Math.abs(segment.to.r - segment.from.r)];
  const [less, more] = [Math.min(long, tall), Math.max(long, tall)],
    isLine = segment.kind === "line";
  if (isLine && less < LEVEL) return true;
  const share = isLine && less < SIDE.steep * more ? SIDE.share : SHORT;
  return Math.hypot(long, tall) >= share * size;
}

/** The features of the contours on the finished part; if the program turns none, those of the part itself. */
export function featuresOf(
  contours: readonly TurnedContour[],
  finished: readonly Ring[],
  blank: readonly Ring[],
): Features {
  const edges = edgesOf(finished),
    ofBlank = edgesOf(blank);
  const onPart = (p: Pt) => edges.length === 0 || edges.some((edge) => part.distanceTo(edge, p) < NEAR);
  const isOwn = (edge: Segment) => !ofBlank.some((side) => part.distanceTo(side, part.pointOn(edge, 0.5)) < LEVEL);
  const all: readonly TurnedContour[] = contours.some(({ segments }) => segments.length > 0)
    ? contours
    : [{ segments: edges.filter(isOwn) }];
  const box = boxAround([...finished]);
  const size = finished.length > 0 ? Math.hypot(box.right - box.left, box.high - box.low) : 0;
  const diameters: DiameterFeature[] = [];
  const positions: PositionFeature[] = [];
  for (const { segments, thread } of all) {
    const shown = segments.filter((each) => isShown(each, size)),
      found = printFeatures(shown);
    for (const { r, left, right } of found.cylinders) {
      const seen = [right, (left + right) / 2, left].map((z) => at(z, r)).find(onPart);
      if (!seen) continue;
      const outside =
        inMaterial(finished, at(seen.z, Math.max(0, r - ASIDE))) || !inMaterial(finished, at(seen.z, r + ASIDE));
      const i = diameters.findIndex((d) => d.outside === outside && Math.abs(d.at.r - r) < ONE),
        known = diameters[i],
        carried = thread ?? known?.thread;
      diameters[i < 0 ? diameters.length : i] = {
        at: known && known.at.z > seen.z ? known.at : seen,
        outside,
        extent: (known?.extent ?? 0) + right - left,
        ...(carried && { thread: carried }),
      };
    }
    const upright = (z: number) =>
      shown.filter((s) => [s.from.z, s.to.z].every((end) => Math.abs(end - z) < LEVEL)).map((s) => [s.from.r, s.to.r]);
    for (const p of found.positions) {
      const sides = upright(p.z).map(([a = 0, b = 0]) => [Math.abs(a - b), (a + b) / 2] as const);
      const seen = [p, ...sides.map(([, middle]) => at(p.z, middle))].find(onPart);
      // A contour may run out beyond the part.
      if (!seen || (sides.length === 0 && edges.length > 0 && (p.z > box.right + ONE || p.z < box.left - ONE)))
        continue;
      const i = positions.findIndex((d) => Math.abs(d.at.z - p.z) < ONE),
        known = positions[i];
      positions[i < 0 ? positions.length : i] = {
        at: known && known.at.r >= seen.r ? known.at : seen,
        extent: sides.reduce((sum, [long]) => sum + long, known?.extent ?? 0),
      };
    }
  }
  return withBlank({ diameters, positions }, blank);
}

/** The sizes of the blank that are not also sizes of the part. */
function withBlank({ diameters, positions }: Features, blank: readonly Ring[]): Features {
  if (blank.length === 0) return { diameters, positions };
  const { left, right, high, low } = boxAround([...blank]);
  const across = [{ at: at(left, high), outside: true }, ...(low > ONE ? [{ at: at(left, low), outside: false }] : [])];
  return {
    diameters: [
      ...diameters,
      ...across
        .filter((own) => !diameters.some((d) => d.outside === own.outside && Math.abs(d.at.r - own.at.r) < ONE))
        .map((own) => ({
          ...own,
          ofBlank: true as const,
          extent: Infinity,
        })),
    ],
    positions: [
      ...positions,
      ...[left, right]
        .filter((z) => !positions.some((p) => Math.abs(p.at.z - z) < ONE))
        .map((z) => ({
          at: at(z, high),
          ofBlank: true as const,
          extent: Infinity,
        })),
    ],
  };
}
