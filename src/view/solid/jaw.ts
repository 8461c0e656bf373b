import { boxOf } from "../../kernel/area/box.ts";
import { intersection } from "../../kernel/area/clip.ts";
import { at, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import { trianglesOf } from "./fill.ts";
import { MeshBuilder, type Mesh } from "./mesh.ts";

/** A jaw upright over the axis: its body, and its edges as lines. */
export interface Jaw {
  readonly mesh: Mesh;
  readonly edges: Float32Array;
}

/**
 * A jaw is no wider to each side than its radius times this: at the tangent of 60° it would meet the next one of three.
 */
const SPREAD = 1.4;
/** Length of a normal of the sides that run together. */
const SLANT = Math.hypot(1, SPREAD);

/** An outline with corners where it crosses a radius, mm. */
const cornered = (ring: Ring, radius: number): Ring =>
  ring.flatMap((p, i) => {
    const q = ring[(i + 1) % ring.length] ?? p;
    if ((p.r - radius) * (q.r - radius) >= 0) return [p];
    return [p, at(p.z + ((radius - p.r) / (q.r - p.r)) * (q.z - p.z), radius)];
  });

/** The part of an outline between two radii, mm. */
function between(ring: Ring, low: number, high: number): readonly Ring[] {
  if (high <= low) return [];
  const { left, right } = boxOf(ring);
  return intersection([ring], [[at(left, low), at(right, low), at(right, high), at(left, high)]]);
}

/**
 * A jaw of an outline (counter-clockwise), half its width to each side, mm. Near the axis its sides run together, so
 * that three of them never meet however small the work is.
 */
export function jawOf(outline: Ring, half: number): Jaw {
  const { high } = boxOf(outline),
    above = boxOf(outline).low < 0 ? (between(outline, 0, high)[0] ?? outline) : outline;
  const { low } = boxOf(above),
    full = Math.max(low, half / SPREAD),
    ring = cornered(above, full);
  const wide = ({ r }: Pt) => Math.min(half, SPREAD * r);
  const build = new MeshBuilder();
  const side = (rings: readonly Ring[], way: 1 | -1, [nr, ny]: readonly [number, number]) => {
    const triangles = trianglesOf(rings),
      corners = rings.flat().map((p) => build.corner(p.r, way * wide(p), p.z, nr, way * ny, 0));
    for (let i = 0; i < triangles.length; i += 3) {
      const [a = 0, b = 0, c = 0] = [0, 1, 2].map((k) => corners[triangles[i + k] ?? 0]);
      if (way > 0) build.triangle(a, b, c);
      else build.triangle(a, c, b);
    }
  };
  for (const way of [1, -1] as const) {
    side(between(ring, full, high), way, [0, 1]);
    side(between(ring, low, Math.min(full, high)), way, [-SPREAD / SLANT, 1 / SLANT]);
  }
  ring.forEach((p, i) => wall(build, [p, ring[(i + 1) % ring.length] ?? p], wide));
  return { mesh: build.mesh(), edges: edgesOf(ring, wide, full) };
}

/** The face that a piece of the outline makes across the jaw. */
function wall(build: MeshBuilder, [p, q]: readonly [Pt, Pt], wide: (p: Pt) => number): void {
  const [dz, dr] = [q.z - p.z, q.r - p.r],
    long = Math.hypot(dz, dr);
  if (long === 0) return;
  const corner = (of: Pt, way: number) => build.corner(of.r, way * wide(of), of.z, -dz / long, 0, dr / long);
  const [a, b, c, d] = [corner(p, 1), corner(p, -1), corner(q, -1), corner(q, 1)];
  build.triangle(a, b, c);
  build.triangle(a, c, d);
}

/** Corners of an outline that turn less than this, radians, belong to a break line. */
const SHARP = 0.5;

/** Whether the outline has an edge at one of its corners. */
function isEdge(before: Pt, p: Pt, after: Pt): boolean {
  const [az, ar, bz, br] = [p.z - before.z, p.r - before.r, after.z - p.z, after.r - p.r];
  return Math.abs(Math.atan2(az * br - ar * bz, az * bz + ar * br)) > SHARP;
}

/** Both outlines, the lines across between them, and those where the sides begin to run together. */
function edgesOf(ring: Ring, wide: (p: Pt) => number, full: number): Float32Array {
  const out: number[] = [];
  const line = (p: Pt, y: number, q: Pt, to: number) => out.push(p.r, y, p.z, q.r, to, q.z);
  ring.forEach((p, i) => {
    const q = ring[(i + 1) % ring.length] ?? p;
    for (const way of [1, -1]) line(p, way * wide(p), q, way * wide(q));
    if (p.r !== full && isEdge(ring.at(i - 1) ?? p, p, q)) line(p, -wide(p), p, wide(p));
  });
  const bends = ring.filter(({ r }) => r === full).sort((a, b) => a.z - b.z),
    { low } = boxOf(ring);
  if (full > low) {
    for (let i = 0; i + 1 < bends.length; i += 2) {
      const [p, q] = [bends[i], bends[i + 1]];
      if (p && q) {
        for (const way of [1, -1]) line(p, way * wide(p), q, way * wide(q));
      }
    }
  }
  return Float32Array.from(out);
}
