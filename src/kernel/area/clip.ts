import {
  Clipper64,
  ClipType,
  EndType,
  FillRule,
  inflatePaths,
  JoinType,
  PathType,
  pointInPolygon,
  PointInPolygonResult,
  simplifyPaths,
  type Path64,
} from "clipper2-ts";
import { areaOfRing } from "./area.ts";
import type { Pt, Ring } from "../geometry/point.ts";
import { CHORD, GRID } from "../tolerance.ts";
import { axial, radius } from "../units.ts";

/*
 * Areas as sets of rings, mm: outer rings run counter-clockwise, holes clockwise, and overlaps count once (non-zero
 * rule). This is the only file that knows the polygon engine. It counts in integers of GRID, so every result lies on
 * that grid and goes through it again unchanged.
 */

/** Rings as the engine's integers, for storing and for sending to another thread: z, r, z, r … of one ring each. */
export type PackedRings = readonly Float64Array[];

/** Units per mm; a whole number, so that packing and unpacking are exact. */
const UNITS = Math.round(1 / GRID);
const toGrid = (mm: number) => Math.round(mm * UNITS);
const fromGrid = (n: number) => n / UNITS;
const point = (x: number, y: number): Pt => ({ z: axial(fromGrid(x)), r: radius(fromGrid(y)) });

/** A ring that is not finite would silently make the engine forget everything else, so it is left out. */
function paths(rings: readonly Ring[]): Path64[] {
  const out: Path64[] = [];
  for (const ring of rings) {
    if (ring.length < 3) continue;
    const path: Path64 = new Array<Path64[number]>(ring.length);
    let finite = true;
    for (let i = 0; i < ring.length; i += 1) {
      const p = ring[i] as Pt;
      const x = toGrid(p.z);
      const y = toGrid(p.r);
      finite &&= Number.isFinite(x) && Number.isFinite(y);
      path[i] = { x, y };
    }
    if (finite) out.push(path);
  }
  return out;
}

/** Smaller rings are rounding of the engine, mm². */
const DUST = 100 * GRID * GRID;

const rings = (solution: readonly Path64[]): Ring[] => withoutDust(solution.map((p) => p.map((q) => point(q.x, q.y))));
const withoutDust = (area: readonly Ring[]): Ring[] =>
  area.filter((ring) => ring.length > 2 && Math.abs(areaOfRing(ring)) > DUST);

function combine(type: ClipType, subject: readonly Ring[], clip: readonly Ring[]): Ring[] {
  const engine = new Clipper64();
  engine.preserveCollinear = false;
  engine.addPaths(paths(subject), PathType.Subject);
  if (clip.length > 0) engine.addPaths(paths(clip), PathType.Clip);
  const solution: Path64[] = [];
  engine.execute(type, FillRule.NonZero, solution);
  return rings(solution);
}

/** The area in `subject` and not in `clip`. */
export const difference = (subject: readonly Ring[], clip: readonly Ring[]): Ring[] =>
  combine(ClipType.Difference, subject, clip);

/** The area in both. */
export const intersection = (subject: readonly Ring[], clip: readonly Ring[]): Ring[] =>
  combine(ClipType.Intersection, subject, clip);

/** The area in any of the rings, overlaps merged. */
export const union = (area: readonly Ring[], more: readonly Ring[] = []): Ring[] => combine(ClipType.Union, area, more);

/** Distance between an area and the guard ring above it, mm. */
const APART = 1;

/**
 * Grown (delta > 0) or shrunk (delta < 0) on all sides by a length in mm; grown corners are round to CHORD. The engine
 * takes the ring that reaches farthest for an outer ring and reverses everything if that ring runs clockwise, as a hole
 * does that touches the edge of its outer ring. Therefore a guard ring is added beyond all others, and removed from the
 * result.
 */
export function offset(area: readonly Ring[], delta: number): Ring[] {
  const own = paths(area);
  if (!Number.isFinite(delta) || own.length === 0) return [];
  const top = own.reduce((most, path) => path.reduce((m, q) => Math.max(m, q.y), most), -Infinity);
  const [by, apart] = [toGrid(Math.abs(delta)), toGrid(APART)];
  const [low, size] = [top + 2 * by + apart, 4 * by + apart];
  const guard: Path64 = [
    { x: 0, y: low },
    { x: size, y: low },
    { x: size, y: low + size },
    { x: 0, y: low + size },
  ];
  const solution = inflatePaths([...own, guard], delta * UNITS, JoinType.Round, EndType.Polygon, 2, CHORD * UNITS);
  return rings(solution.filter((path) => (path[0]?.y ?? 0) < low - by - apart / 2));
}

/** Whether a point is inside a ring; points on its edge are not. */
export const isInside = (ring: Ring, p: Pt): boolean => {
  const [path] = paths([ring]);
  return (
    path !== undefined && pointInPolygon({ x: toGrid(p.z), y: toGrid(p.r) }, path) === PointInPolygonResult.IsInside
  );
};

/** The same for many points in an area with holes, which is read once. */
export function insideOf(area: readonly Ring[]): (p: Pt) => boolean {
  const outlines = paths(area);
  return (p) => {
    const at = { x: toGrid(p.z), y: toGrid(p.r) };
    let isIn = false;
    for (const path of outlines) if (pointInPolygon(at, path) === PointInPolygonResult.IsInside) isIn = !isIn;
    return isIn;
  };
}

/** Simplified outlines: removed corners were no farther than `within` mm from the straight line that replaces them. */
export const simplified = (area: readonly Ring[], within: number): Ring[] =>
  rings(simplifyPaths(paths(area), within * UNITS, true));

/** The same for an open line of points; its ends are kept. */
export const coarsened = (line: readonly Pt[], within: number): Pt[] =>
  simplifyPaths([line.map((p) => ({ x: toGrid(p.z), y: toGrid(p.r) }))], within * UNITS, false)
    .flat()
    .map(({ x, y }) => point(x, y));

/** Without parts thinner than `width` mm; the rest is unchanged, except for corners rounded by half that width. */
export const opened = (area: readonly Ring[], width: number): Ring[] => offset(offset(area, -width / 2), width / 2);

/** The compact form of rings that lie on the grid. */
export const packed = (area: readonly Ring[]): PackedRings =>
  area.map((ring) => {
    const numbers = new Float64Array(2 * ring.length);
    ring.forEach((p, i) => {
      numbers[2 * i] = toGrid(p.z);
      numbers[2 * i + 1] = toGrid(p.r);
    });
    return numbers;
  });

/** Rings from their compact form. */
export const unpacked = (area: PackedRings): Ring[] =>
  area.map((numbers) =>
    Array.from({ length: numbers.length / 2 }, (_, i) => point(numbers[2 * i] ?? 0, numbers[2 * i + 1] ?? 0)),
  );
