import { boxAround } from "../../kernel/area/box.ts";
import { isInside } from "../../kernel/area/clip.ts";
import { at, part, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";

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
 * grooves.
 */
const SHORT = 0.05,
  SIDE = 0.02;
/** The side of a groove leaves its axis by less than this share of its length. */
const STEEP = 0.27;

const inMaterial = (rings: readonly Ring[], p: Pt): boolean =>
  rings.filter((ring) => isInside(ring, p)).length % 2 === 1;

function edgesOf(rings: readonly Ring[]): readonly Segment[] {
  return rings.flatMap((ring) =>
    ring.map((from, i): Segment => ({ kind: "line", from, to: ring[(i + 1) % ring.length] ?? from })),
  );
}

const middleOf = (from: Pt, to: Pt): Pt => part.pointOn({ kind: "line", from, to }, 0.5);
const rightEnd = (a: Pt, b: Pt): Pt => (a.z >= b.z ? a : b);

/** The features of the contours on the finished part; if the program turns none, those of the part itself. */
export function featuresOf(
  contours: readonly TurnedContour[],
  finished: readonly Ring[],
  blank: readonly Ring[],
): Features {
  const edges = edgesOf(finished);
  const onPart = (p: Pt) => edges.length === 0 || edges.some((edge) => part.distanceTo(edge, p) < NEAR);
  const turned = contours.flatMap(({ segments, thread }) => segments.map((segment) => ({ segment, thread })));
  const ofBlank = edgesOf(blank);
  const own = edges.filter(
    (edge) => !ofBlank.some((side) => part.distanceTo(side, middleOf(edge.from, edge.to)) < LEVEL),
  );
  const all = turned.length > 0 ? turned : own.map((segment) => ({ segment, thread: undefined }));
  const box = boxAround([...finished]);
  const size = finished.length > 0 ? Math.hypot(box.right - box.left, box.high - box.low) : 0;
  const diameters: DiameterFeature[] = [];
  const positions: PositionFeature[] = [];
  const addDiameter = (p: Pt, extent: number, thread?: TurnedContour["thread"]) => {
    if (p.r < ONE || !onPart(p)) return;
    const outside =
      inMaterial(finished, at(p.z, Math.max(0, p.r - ASIDE))) || !inMaterial(finished, at(p.z, p.r + ASIDE));
    const i = diameters.findIndex((d) => d.outside === outside && Math.abs(d.at.r - p.r) < ONE);
    const known = diameters[i];
    const carried = thread ?? known?.thread;
    const next = {
      at: known ? rightEnd(known.at, p) : p,
      outside,
      extent: (known?.extent ?? 0) + extent,
      ...(carried && { thread: carried }),
    };
    if (known) diameters[i] = next;
    else diameters.push(next);
  };
  const addPosition = (p: Pt, extent: number) => {
    if (!onPart(p)) return;
    const i = positions.findIndex((d) => Math.abs(d.at.z - p.z) < ONE);
    const known = positions[i];
    const next = { at: known && known.at.r >= p.r ? known.at : p, extent: (known?.extent ?? 0) + extent };
    if (known) positions[i] = next;
    else positions.push(next);
  };
  for (const { segment, thread } of all) {
    const { from, to } = segment,
      [long, tall] = [Math.abs(to.z - from.z), Math.abs(to.r - from.r)];
    const isLine = segment.kind === "line";
    if (isLine && tall < LEVEL) {
      const middle = middleOf(from, to),
        seen = [rightEnd(from, to), middle, from, to].find(onPart);
      if (long > LEVEL && seen) addDiameter(at(seen.z, from.r), long, thread);
    } else if (isLine && long < LEVEL) {
      const seen = [middleOf(from, to), from, to].find(onPart);
      if (seen) addPosition(at(from.z, seen.r), tall);
    } else if (Math.hypot(long, tall) >= SHORT * size) {
      for (const end of [from, to]) {
        addDiameter(end, 0, thread);
        addPosition(end, 0);
      }
    } else if (isLine && Math.hypot(long, tall) >= SIDE * size && Math.min(long, tall) < STEEP * Math.max(long, tall)) {
      // The side of a groove that opens a little: where it is widest.
      if (tall < long) addDiameter(rightEnd(from, to), 0, thread);
      else addPosition(from.r > to.r ? from : to, 0);
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
