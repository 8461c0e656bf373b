import { at, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { StockLooks, SideLook } from "./finish.ts";

/**
 * A place of an outline with the direction out of the material there, length 1. A sharp corner has two, one for each
 * side.
 */
export interface TurnedPoint {
  readonly p: Pt;
  readonly nz: number;
  readonly nr: number;
}

/** An outline ready to be revolved: for each of its sides the places where it begins and ends. */
export interface Profile {
  readonly points: readonly TurnedPoint[];
  /** Begin and end of each side, as places in `points`. */
  readonly sides: readonly (readonly [number, number])[];
  /** Corners that are seen as an edge, as places in `points`. */
  readonly sharp: readonly number[];
  /** The look of each side, if requested; sides that look different have no place in common. */
  readonly looks: readonly (SideLook | null)[];
}

/** Two chords of one arc never bend more than this at their joint, radians; other corners are sharp. */
const BEND = 0.8;
/** Two chords are one arc if that arc is no farther from them than this, mm: more than any flattening tolerance. */
const FLAT = 0.012;

interface Side {
  readonly nz: number;
  readonly nr: number;
  readonly long: number;
}

/** Whether two sides are chords of one rounding, or a line and the rounding that it runs into. */
function isSmooth(a: Side, b: Side): boolean {
  const bend = Math.atan2(a.nz * b.nr - a.nr * b.nz, a.nz * b.nz + a.nr * b.nr);
  return Math.abs(bend) < BEND && (Math.min(a.long, b.long) * Math.abs(bend)) / 8 < FLAT;
}

/** Points nearer to the axis than the control's resolution lie on it. */
const settled = (p: Pt): Pt => (p.r < SAME ? at(p.z, 0) : p);

const isAlike = (a: SideLook | null | undefined, b: SideLook | null | undefined) =>
  a?.texture === b?.texture && a?.tone === b?.tone && !a?.turnAt && !b?.turnAt;

/**
 * A side without a tone that is shorter than this, mm, and between two sides with one takes the tone before it: it
 * would be a speck.
 */
const SPECK = 0.15;

/** The looks of sides, one after the other round an outline, without specks. */
function unspecked(looks: readonly (SideLook | null)[], sides: readonly Side[]): readonly (SideLook | null)[] {
  return looks.map((look, i) => {
    const before = looks.at(i - 1)?.tone ?? null,
      after = looks[(i + 1) % looks.length]?.tone ?? null;
    const isSpeck = look?.tone === null && (sides[i]?.long ?? 0) < SPECK && after !== null;
    return isSpeck && before !== null ? { ...look, tone: before } : look;
  });
}

/**
 * An outline (material to the left) as smooth and sharp places; null if it encloses nothing. `ring` must have been
 * split by `finish`.
 */
export function profileOf(ring: Ring, finish?: StockLooks): Profile | null {
  const corners = ring.map(settled).filter((p, i, all) => {
    const before = all[(i + all.length - 1) % all.length];
    return !before || p.z !== before.z || p.r !== before.r;
  });
  if (corners.length < 3) return null;
  const sides = corners.map((p, i): Side => {
    const to = corners[(i + 1) % corners.length] ?? p;
    const [dz, dr] = [to.z - p.z, to.r - p.r],
      long = Math.hypot(dz, dr) || 1;
    return { nz: dr / long, nr: -dz / long, long };
  });
  const looks = unspecked(
    corners.map((p, i) => finish?.of(p, corners[(i + 1) % corners.length] ?? p) ?? null),
    sides,
  );
  const points: TurnedPoint[] = [],
    sharp: number[] = [];
  const ends = corners.map((p, i) => {
    const before = sides[(i + sides.length - 1) % sides.length],
      after = sides[i];
    if (!before || !after) return [0, 0] as const;
    const first = points.length;
    if (!isSmooth(before, after)) {
      points.push({ p, nz: before.nz, nr: before.nr }, { p, nz: after.nz, nr: after.nr });
      if (p.r > 0) sharp.push(first);
      return [first, first + 1] as const;
    }
    // The longer side is nearer to the true direction: a line that runs into a rounding keeps its own.
    const [nz, nr] = [before.nz * before.long + after.nz * after.long, before.nr * before.long + after.nr * after.long];
    const size = Math.hypot(nz, nr) || 1,
      point = { p, nz: nz / size, nr: nr / size };
    points.push(point);
    if (isAlike(looks[(i + looks.length - 1) % looks.length], looks[i])) return [first, first] as const;
    points.push(point);
    return [first, first + 1] as const;
  });
  return {
    points,
    sides: ends.map(([, out], i) => [out, ends[(i + 1) % ends.length]?.[0] ?? out] as const),
    sharp,
    looks,
  };
}
