import { at, part, type Pt, type Segment } from "../../kernel/geometry/point.ts";

/** A turned surface of one diameter, from its end near the chuck to its free end. Part space, mm. */
export interface PrintCylinder {
  readonly r: number;
  readonly left: number;
  readonly right: number;
  /** The end of a cone that follows from the other end, the angle and the length. */
  readonly follows: boolean;
}

/**
 * A corner that is broken, or the angle of a cone, with the place that its leader shows. Size mm, of an angle degrees;
 * angle degrees from the axis. `across`: how far a chamfer beside a cone goes along the other surface, mm.
 */
export type PrintCorner =
  | {
      readonly kind: "chamfer";
      readonly at: Pt;
      readonly size: number;
      readonly angle: number;
      readonly across: number | null;
    }
  | { readonly kind: "radius" | "angle"; readonly at: Pt; readonly size: number };

/** The features of one outline that a drawing dimensions. */
export interface PrintFeatures {
  readonly cylinders: readonly PrintCylinder[];
  /** Positions along the axis, each with the point where its dimension begins. */
  readonly positions: readonly Pt[];
  readonly corners: readonly PrintCorner[];
}

/** Straight along an axis within this, mm; nearer values are one size, mm. */
const LEVEL = 0.001,
  ONE = 0.005;
/** A corner that is broken by at most this share of the outline's extent, and by this many mm whatever that is. */
const BROKEN = { share: 0.12, most: 6 } as const;
/** Sides of a broken corner leave it, and each other, by more than this: the sine. */
const BENT = 0.17;
/** How far two directions may differ where an arc runs into a line without a corner: the sine. */
const SMOOTH = 0.02;

interface Piece {
  readonly segment: Segment;
  readonly corner: PrintCorner | null;
}

const long = (s: Segment): number => Math.abs(s.to.z - s.from.z);
const tall = (s: Segment): number => Math.abs(s.to.r - s.from.r);
const isLevel = (s: Segment) => s.kind === "line" && tall(s) < LEVEL;
const isUpright = (s: Segment) => s.kind === "line" && long(s) < LEVEL;

function sine(a: Segment, b: Segment): number {
  const [p, q] = [part.direction(a, a.to), part.direction(b, b.from)];
  return Math.abs(p.z * q.r - p.r * q.z);
}

function runsInto(a: Segment | undefined, b: Segment | undefined): boolean {
  if (!a || !b) return false;
  const [p, q] = [part.direction(a, a.to), part.direction(b, b.from)];
  return Math.abs(p.z * q.r - p.r * q.z) < SMOOTH && p.z * q.z + p.r * q.r > 0;
}

/** A segment between two others as a broken corner; null if it is none. */
function cornerOf(
  before: Segment | undefined,
  s: Segment,
  after: Segment | undefined,
  most: number,
): PrintCorner | null {
  const middle = part.pointOn(s, 1 / 2);
  if (s.kind === "arc") {
    const size = part.radiusOf(s);
    return size <= most && (runsInto(before, s) || runsInto(s, after)) ? { kind: "radius", at: middle, size } : null;
  }
  if (isLevel(s) || isUpright(s) || Math.max(long(s), tall(s)) > most / 2) return null;
  // The first segment may begin at the free end, and the last one may run out onto the blank.
  if (!before && !after) return null;
  if (before?.kind === "arc" || after?.kind === "arc") return null;
  if (before && !isLevel(before) && !isUpright(before) && part.lengthOf(before) < part.lengthOf(s)) return null;
  if ((before && sine(before, s) < BENT) || (after && sine(s, after) < BENT)) return null;
  if (before && after && sine(before, after) < BENT) return null;
  return { kind: "chamfer", at: middle, size: long(s), angle: angleOf(s), across: acrossCone(before, s, after) };
}

/** The leg of a chamfer on the face that it shares with a cone; null where its angle is measured from the axis. */
function acrossCone(before: Segment | undefined, s: Segment, after: Segment | undefined): number | null {
  if (!before || !after) return null;
  const [face, cone, end] = isUpright(before) ? [before, after, s.from] : [after, before, s.to];
  if (!isUpright(face) || !isCone(cone)) return null;
  const [sharp] = part.meetings(face, cone);
  return sharp ? part.apart(sharp, end) : null;
}

/** Degrees from the axis. */
const angleOf = (s: Segment): number => (Math.atan2(tall(s), long(s)) * 180) / Math.PI;
const isCone = (s: Segment): boolean => s.kind === "line" && !isLevel(s) && !isUpright(s);
/** Angles are drawn where they are multiples of this, degrees. */
const ANGLE_STEP = 0.5;

/** The angle of a cone; null where it is no usual one, so that its two diameters state it. */
function usualAngle(s: Segment): number | null {
  if (!isCone(s)) return null;
  const angle = Math.round(angleOf(s) / ANGLE_STEP) * ANGLE_STEP;
  const off = ((angle - angleOf(s)) * Math.PI) / 180;
  return Math.abs(off) * part.lengthOf(s) < AS_NEAR ? angle : null;
}

/**
 * Steps per mm of a length and of a radius (hundredths of the ⌀); an end of a cone this near to a step snaps to it, mm.
 */
const GRID = { z: 100, r: 200 } as const,
  AS_NEAR = 0.0012;
const tidied = (value: number, grid: number): number => {
  const round = Math.round(value * grid) / grid;
  return Math.abs(round - value) < AS_NEAR ? round : value;
};
/** Distance of a radius from the next diameter in hundredths, mm. */
const offGrid = (r: number): number => Math.abs(Math.round(r * GRID.r) / GRID.r - r);
/** Nearer to a hundredth than this it is one, mm; farther, it may be near by chance. */
const EXACT = 0.0003;
/**
 * The end of a cone that follows from the other end, which has a diameter in hundredths, and from a usual angle; null
 * where both diameters state the cone.
 */
function followingEnd(s: Segment): Pt | null {
  const [known, other] = offGrid(s.from.r) < offGrid(s.to.r) ? [s.from, s.to] : [s.to, s.from];
  const isStated = usualAngle(s) !== null && offGrid(known.r) < AS_NEAR && offGrid(other.r) > EXACT;
  return isStated ? other : null;
}
const tidy = (p: Pt): Pt => at(tidied(p.z, GRID.z), tidied(p.r, GRID.r));

/** Extends the lines on both sides of a broken corner to where they meet, as if it were sharp. */
function sharpened(pieces: readonly Piece[]): Segment[] {
  const main: { segment: Segment; broken: boolean }[] = [];
  let broken = false;
  for (const { segment, corner } of pieces) {
    if (corner) broken = true;
    else {
      const last = main.at(-1);
      const meeting =
        broken && last?.segment.kind === "line" && segment.kind === "line"
          ? part.meetings(last.segment, segment)[0]
          : undefined;
      if (last && meeting) {
        main[main.length - 1] = { ...last, segment: part.line(last.segment.from, meeting) };
        main.push({ segment: part.line(meeting, segment.to), broken });
      } else main.push({ segment, broken });
      broken = false;
    }
  }
  return main.map(({ segment }) => segment);
}

/**
 * The sizes that one outline of a turned part needs: its diameters, its positions along the axis, and its broken
 * corners.
 */
export function printFeatures(outline: readonly Segment[]): PrintFeatures {
  const extent = Math.max(
    0,
    ...outline.flatMap((s) => [s.from, s.to].map((p) => Math.hypot(p.z - (outline[0]?.from.z ?? 0), p.r))),
  );
  const most = Math.min(BROKEN.most, BROKEN.share * extent);
  const pieces = outline.map((segment, i): Piece => ({
    segment,
    corner: cornerOf(outline[i - 1], segment, outline[i + 1], most),
  }));
  const cylinders: PrintCylinder[] = [];
  const positions: Pt[] = [];
  const corners = pieces.flatMap(({ corner }) => (corner ? [corner] : []));
  const addPosition = (p: Pt) => {
    const i = positions.findIndex(({ z }) => Math.abs(z - p.z) < ONE),
      known = positions[i];
    if (!known) positions.push(p);
    else if (p.r > known.r) positions[i] = p;
  };
  const addDiameter = (left: number, right: number, r: number, follows = false) => {
    const known = cylinders.some(
      (c) => Math.abs(c.r - r) < ONE && (left === right ? c.left - ONE <= left && right <= c.right + ONE : false),
    );
    if (r > ONE && !known) cylinders.push({ r, left, right, follows });
  };
  const main = sharpened(pieces);
  for (const s of main.filter(isLevel)) addDiameter(Math.min(s.from.z, s.to.z), Math.max(s.from.z, s.to.z), s.from.r);
  for (const s of main) {
    if (isLevel(s)) continue;
    addPosition(s.from.r > s.to.r ? s.from : s.to);
    if (isUpright(s)) continue;
    const follows = followingEnd(s);
    for (const end of [s.from, s.to]) {
      const p = tidy(end);
      addPosition(p);
      addDiameter(p.z, p.z, p.r, end === follows);
    }
    if (follows) corners.push({ kind: "angle", at: part.pointOn(s, 1 / 2), size: usualAngle(s) ?? 0 });
    if (s.kind === "arc") corners.push({ kind: "radius", at: part.pointOn(s, 1 / 2), size: part.radiusOf(s) });
  }
  const last = main.at(-1);
  if (last) addPosition(last.to);
  return { cylinders, positions, corners };
}
