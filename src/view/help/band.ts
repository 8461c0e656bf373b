import type { Pt } from "../../kernel/point.ts";
import { axial, radius } from "../../kernel/units.ts";

/** Pieces flatter than this against an axis get no oversize from the other one. */
const FLAT = 0.02;

const shifted = (p: Pt, z: number, r: number): Pt => ({ z: axial(p.z + z), r: radius(p.r + r) });

/** Whether the open side lies to the left (1) or to the right (−1) of a contour: from the turn of the area it bounds. */
export function openSide(area: readonly Pt[]): 1 | -1 {
  const twice = area.reduce((sum, p, i) => {
    const next = area[(i + 1) % area.length] ?? p;
    return sum + p.z * next.r - next.z * p.r;
  }, 0);
  return twice >= 0 ? 1 : -1;
}

/** What the cycle leaves as oversize: each piece of the contour moved away from the part by ±z and ±r, mm. */
export function grownLine(line: readonly Pt[], side: 1 | -1, z: number, r: number): { readonly outer: Pt[]; readonly pieces: Pt[][] } {
  const outer: Pt[] = [];
  const pieces: Pt[][] = [];
  line.forEach((b, i) => {
    const a = line[i - 1];
    if (!a) return;
    const long = Math.hypot(b.z - a.z, b.r - a.r);
    if (long < 1e-9) return;
    const [nz, nr] = [(-side * (b.r - a.r)) / long, (side * (b.z - a.z)) / long];
    const away = (n: number, by: number) => (Math.abs(n) > FLAT ? Math.sign(n) * by : 0);
    const [p, q] = [shifted(a, away(nz, z), away(nr, r)), shifted(b, away(nz, z), away(nr, r))];
    const last = outer.at(-1);
    if (last) pieces.push([a, p, last]);
    pieces.push([a, b, q, p]);
    outer.push(p, q);
  });
  return { outer, pieces };
}
