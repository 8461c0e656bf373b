import { hypotenuse } from "../../kernel/geometry/vectors.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import type { SurfaceOrigin, StockSide, Surfaces } from "./surfaces.ts";

/** A piece of the boundary that one move made. */
export interface SurfaceEdge extends StockSide {
  readonly made: SurfaceOrigin;
}

/** A vertex where the boundary turns sharply, with the edges on both sides of it (−1: beyond the window). */
export interface Bend {
  readonly z: number;
  readonly r: number;
  readonly before: number;
  readonly after: number;
}

/** The boundary of the stock in a window along Z, in the order of its rings. */
export interface Boundary {
  readonly edges: readonly SurfaceEdge[];
  readonly corners: readonly Bend[];
}

/**
 * Turns smaller than this belong to one round surface, radians; between short chords of small radii they may be larger.
 */
const TURN = 0.21;
const SHORT_TURN = 0.65;
/** Shorter chords belong to a radius, mm. */
const SHORT = 0.12;

function isSharp(a: StockSide, b: StockSide): boolean {
  const [az, ar, bz, br] = [a.z1 - a.z0, a.r1 - a.r0, b.z1 - b.z0, b.r1 - b.r0];
  const turn = Math.abs(Math.atan2(az * br - ar * bz, az * bz + ar * br));
  return turn > (Math.max(hypotenuse(az, ar), hypotenuse(bz, br)) > SHORT ? TURN : SHORT_TURN);
}

/** Where a ring begins: at its left end, which is in the chuck, so that no machined surface is split. */
const leftmost = (ring: Ring) => ring.reduce((best, p, i) => (p.z < (ring[best]?.z ?? Infinity) ? i : best), 0);

/** The edges between two places on Z, each with its origin. */
export function boundaryIn(
  rings: readonly Ring[],
  surfaces: Surfaces,
  now: PlayPosition,
  left: number,
  right: number,
): Boundary {
  const edges: SurfaceEdge[] = [],
    corners: Bend[] = [];
  for (const ring of rings) {
    const count = ring.length,
      start = leftmost(ring);
    const vertex = (i: number) => ring[(start + i + count) % count];
    const sideAt = (i: number): StockSide | null => {
      const p = vertex(i),
        q = vertex(i + 1);
      return p && q ? { z0: p.z, r0: p.r, z1: q.z, r1: q.r } : null;
    };
    /** Index of the first and the last edge of the previous side, and of the first side. */
    let before = -1,
      first = -1,
      sideBefore: StockSide | null = null;
    for (let i = 0; i < count; i += 1) {
      const p = vertex(i),
        q = vertex(i + 1);
      if (!p || !q || (p.z < left && q.z < left) || (p.z > right && q.z > right)) {
        [before, sideBefore] = [-1, null];
        continue;
      }
      const side: StockSide = { z0: p.z, r0: p.r, z1: q.z, r1: q.r };
      const begin = edges.length;
      for (const { begin: from, end: to, made } of surfaces.of(side, now))
        edges.push({ ...part(side, from, to), made });
      if (i === 0) first = begin;
      const previous = sideBefore ?? sideAt(i - 1);
      if (i > 0 && previous && isSharp(previous, side)) corners.push({ z: side.z0, r: side.r0, before, after: begin });
      [before, sideBefore] = [edges.length - 1, side];
      if (i === count - 1) {
        const next = sideAt(0);
        if (next && isSharp(side, next)) corners.push({ z: next.z0, r: next.r0, before, after: first });
      }
    }
  }
  return { edges, corners };
}

const part = (s: StockSide, from: number, to: number): StockSide => ({
  z0: s.z0 + (s.z1 - s.z0) * from,
  r0: s.r0 + (s.r1 - s.r0) * from,
  z1: to === 1 ? s.z1 : s.z0 + (s.z1 - s.z0) * to,
  r1: to === 1 ? s.r1 : s.r0 + (s.r1 - s.r0) * to,
});

/**
 * Air between the axis and the material, or between two parts of it, with the edge of the wall that closes it outwards.
 */
export interface Gap {
  readonly low: number;
  readonly high: number;
  readonly edge: number;
}

/** The stock in equal columns along Z, each sampled in its middle. */
export interface Columns {
  readonly left: number;
  readonly width: number;
  readonly count: number;
  /** Greatest distance of the material from the axis; 0 where there is none. */
  readonly top: Float64Array;
  /** The edge there; −1 where there is none. */
  readonly edge: Int32Array;
  /** The hollows below it, from the axis outwards. */
  readonly gaps: readonly (readonly Gap[])[];
}

const NONE: readonly Gap[] = [];

/** The gaps between crossings given as r, edge, r, edge, … */
function gapsOf(crossings: readonly number[]): readonly Gap[] {
  if (crossings.length < 2) return NONE;
  const sorted: [number, number][] = [];
  for (let i = 0; i < crossings.length; i += 2) sorted.push([crossings[i] as number, crossings[i + 1] as number]);
  sorted.sort((a, b) => a[0] - b[0]);
  const out: Gap[] = [];
  let low = 0;
  sorted.forEach(([r, edge], i) => {
    if (i % 2 === 0 && r > low) out.push({ low, high: r, edge });
    low = r;
  });
  return out.length > 0 ? out : NONE;
}

/** Cuts a boundary into columns from `left` on. */
export function columnsOf(edges: readonly SurfaceEdge[], left: number, width: number, count: number): Columns {
  const top = new Float64Array(count),
    edge = new Int32Array(count).fill(-1);
  const crossings: number[][] = Array.from({ length: count }, () => []);
  edges.forEach(({ z0, r0, z1, r1 }, e) => {
    const [low, high] = z0 < z1 ? [z0, z1] : [z1, z0];
    if (!(low < high)) return;
    const slope = (r1 - r0) / (z1 - z0);
    const from = Math.max(0, Math.ceil((low - left) / width - 0.5));
    for (let j = from; j < count; j += 1) {
      const z = left + (j + 0.5) * width;
      if (z >= high) break;
      const r = r0 + (z - z0) * slope;
      if (r > (top[j] as number)) {
        top[j] = r;
        edge[j] = e;
      }
      crossings[j]?.push(r, e);
    }
  });
  return { left, width, count, top, edge, gaps: crossings.map(gapsOf) };
}
