import type { Clamped } from "../../kernel/area/clamping.ts";
import { intersection } from "../../kernel/area/clip.ts";
import { at, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { Bounds } from "../camera.ts";

/** How much of a clamping is drawn over the blank and beside it, as parts of the radius of the blank. */
const [OUT, ALONG] = [1, 0.5];

/** The clamping near the work: its areas, and their edges except where it is cut off. */
export interface ClampingNear {
  readonly areas: readonly Ring[];
  readonly edges: readonly (readonly [Pt, Pt])[];
}

/**
 * The clamping of a blank, cut off near it, because a chuck is far larger than most parts. No edge is drawn where the
 * clamping continues.
 */
export function clampingNear(
  { clamping: { face, length, tailstock }, bodies }: Clamped,
  { left, right, high }: Bounds,
): ClampingNear {
  const back = Math.min(left, face - length) - ALONG * high,
    front = Math.max(right, tailstock?.tip ?? right) + ALONG * high;
  const out = (1 + OUT) * high,
    near = [at(back, 0), at(front, 0), at(front, out), at(back, out)];
  const areas = bodies.flatMap(({ part, rings }) => (part === "limit" ? [] : intersection(rings, [near])));
  const same = (a: number, b: number, place: number) => Math.abs(a - place) < SAME && Math.abs(b - place) < SAME;
  const isCut = (p: Pt, q: Pt) =>
    same(p.z, q.z, back) || same(p.z, q.z, front) || same(p.r, q.r, out) || same(p.r, q.r, 0);
  const sides = areas.flatMap((ring) => ring.map((p, i) => [p, ring[(i + 1) % ring.length] ?? p] as const));
  return { areas, edges: sides.filter(([p, q]) => !isCut(p, q)) };
}
