import { boxAround } from "../../kernel/area/box.ts";
import { isInside } from "../../kernel/area/clip.ts";
import { at, part, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import { printFeatures, type PrintCylinder } from "./print-features.ts";

/** What a thread adds to its diameter: lead, mm, and number of starts. */
export interface TurnedThread {
  readonly lead: number;
  readonly starts: number;
}

/** One contour that a program turns, with the thread that it carries. */
export interface TurnedContour {
  readonly segments: readonly Segment[];
  readonly thread?: TurnedThread;
}

/** A turned surface of the part; `extent`: its length, mm: the shortest are left out first. */
export interface FoundCylinder extends PrintCylinder {
  readonly isBore: boolean;
  readonly extent: number;
  readonly thread?: TurnedThread;
}

/** A position along the axis, where its line begins; `extent`: the length of its faces, mm. */
export interface FoundPosition {
  readonly from: Pt;
  readonly extent: number;
}

/** Nearer values are one, mm. */
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

const edgesOf = (rings: readonly Ring[]): readonly Segment[] =>
  rings.flatMap((ring) => ring.map((from, i) => part.line(from, ring[(i + 1) % ring.length] ?? from)));

/** Whether an element counts on a part of a size: the others are broken edges. */
function isShown(segment: Segment, size: number): boolean {
  const [long, tall] = [Math.abs(segment.to.z - segment.from.z), Math.abs(segment.to.r - segment.from.r)];
  const [less, more] = [Math.min(long, tall), Math.max(long, tall)],
    isLine = segment.kind === "line";
  if (isLine && less < LEVEL) return true;
  const share = isLine && less < SIDE.steep * more ? SIDE.share : SHORT;
  return Math.hypot(long, tall) >= share * size;
}

/** The main features of the contours on the finished part; if the program turns none, those of the part itself. */
export function featuresOnPart(contours: readonly TurnedContour[], finished: readonly Ring[], blank: readonly Ring[]) {
  const edges = edgesOf(finished),
    ofBlank = edgesOf(blank);
  const onPart = (p: Pt) => edges.length === 0 || edges.some((edge) => part.distanceTo(edge, p) < NEAR);
  const isOwn = (edge: Segment) => !ofBlank.some((side) => part.distanceTo(side, part.pointOn(edge, 0.5)) < LEVEL);
  const all: readonly TurnedContour[] = contours.some(({ segments }) => segments.length > 0)
    ? contours
    : [{ segments: edges.filter(isOwn) }];
  const box = boxAround([...finished]);
  const size = finished.length > 0 ? Math.hypot(box.right - box.left, box.high - box.low) : 0;
  const cylinders: FoundCylinder[] = [],
    positions: FoundPosition[] = [];
  for (const { segments, thread } of all) {
    const shown = segments.filter((each) => isShown(each, size)),
      found = printFeatures(shown);
    for (const own of found.cylinders) {
      const { r, left, right } = own,
        seen = [right, (left + right) / 2, left].find((z) => onPart(at(z, r)));
      if (seen === undefined) continue;
      // Between its ends: at an end a face of the part is neither in its material nor out of it.
      const between = [(left + right) / 2, seen].find((z) => onPart(at(z, r))) ?? seen;
      const isBore =
        !inMaterial(finished, at(between, Math.max(0, r - ASIDE))) && inMaterial(finished, at(between, r + ASIDE));
      cylinders.push({ ...own, right: seen, isBore, extent: right - left, ...(thread && { thread }) });
    }
    for (const p of found.positions) {
      const own = shown.filter((s) => [s.from, s.to].every((end) => Math.abs(end.z - p.z) < LEVEL));
      const from = [p, ...own.map((s) => at(p.z, part.pointOn(s, 0.5).r))].find(onPart);
      // A contour may run out beyond the part.
      const isBeyond = own.length === 0 && edges.length > 0 && (p.z > box.right + ONE || p.z < box.left - ONE);
      if (from && !isBeyond) positions.push({ from, extent: own.reduce((sum, s) => sum + part.lengthOf(s), 0) });
    }
  }
  return { cylinders, positions };
}
