import { boxAround } from "../../kernel/area/box.ts";
import { intersection } from "../../kernel/area/clip.ts";
import { at, type Ring } from "../../kernel/geometry/point.ts";
import type { Bounds } from "../camera.ts";
import { breakOutline, roundBreak } from "../material/break-outline.ts";
import { NO_MESH, type Mesh } from "./mesh.ts";
import { chordsFor, revolved, wholeMesh } from "./revolve.ts";

/** Size of the picture in pixels of a break line: its waves grow with the picture. */
const ACROSS = 420;
/** Corners lie on a break if they are no farther from it than this, mm: positions have single precision. */
const ON = 1e-3;
/** Angle over which the slope of a break line is taken. */
const SLIGHT = 1e-4;

/** Length of a pixel of a break line, mm. */
const pixelOf = ({ left, right, high }: Bounds) => Math.max(right - left, 2 * high) / ACROSS;

/** Outlines in the half plane as far as the break lines. */
export const brokenOutlines = (rings: readonly Ring[], cut: Bounds): readonly Ring[] =>
  intersection(rings, [breakOutline(cut, pixelOf(cut)).map(({ x, y }) => at(x, y))]);

/** A body of revolution as far as the break lines, which run round it. */
export function brokenSolid(
  rings: readonly Ring[],
  cut: Bounds,
): { readonly mesh: Mesh; readonly edges: Float32Array } {
  const kept = intersection(rings, [
    [at(cut.left, 0), at(cut.right, 0), at(cut.right, cut.high), at(cut.left, cut.high)],
  ]);
  if (kept.length === 0) return { mesh: NO_MESH, edges: new Float32Array() };
  const whole = boxAround(rings),
    { high } = boxAround(kept),
    { bend, chords } = roundBreak(high, pixelOf(cut));
  const solid = revolved(kept, { chords: Math.max(chordsFor(high), chords), quarterCut: false }),
    mesh = wholeMesh(solid);
  const isRound = (r: number) => whole.high > cut.high + ON && r > cut.high - ON;
  /** How far the break at an end of the body, if there is one, moves a corner along the axis. */
  const along = (z: number, off: number) => {
    if (whole.left < cut.left - ON && z < cut.left + ON) return off;
    return whole.right > cut.right + ON && z > cut.right - ON ? -off : 0;
  };
  const moved = (list: Float32Array) => {
    const out = new Float32Array(list);
    for (let i = 0; i < out.length; i += 3) {
      const [x = 0, y = 0, z = 0] = list.subarray(i, i + 3),
        r = Math.hypot(x, y),
        off = bend(Math.atan2(y, x));
      const share = isRound(r) ? 1 - off / r : 1;
      out.set([x * share, y * share, z + along(z, (off * r) / high)], i);
    }
    return out;
  };
  /** Normals of a broken cylinder lean to the side on which it is higher. */
  const leant = ({ positions, normals }: Mesh) => {
    const out = new Float32Array(normals);
    for (let i = 0; i < out.length; i += 3) {
      const [x = 0, y = 0] = positions.subarray(i, i + 2),
        r = Math.hypot(x, y);
      if (!isRound(r) || Math.abs(normals[i + 2] ?? 0) > ON) continue;
      const angle = Math.atan2(y, x),
        slope = (bend(angle + SLIGHT) - bend(angle - SLIGHT)) / (2 * SLIGHT * r),
        size = Math.hypot(1, slope);
      out.set([(x - slope * y) / r / size, (y + slope * x) / r / size], i);
    }
    return out;
  };
  return {
    mesh: { ...mesh, positions: moved(mesh.positions), normals: leant(mesh) },
    edges: moved(solid.edges),
  };
}
