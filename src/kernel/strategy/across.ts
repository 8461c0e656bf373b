import { inBox } from "../box.ts";
import { areaOf } from "../area.ts";
import { insertOutline } from "../insert.ts";
import { issue } from "../issue.ts";
import type { Plan, Setting } from "../plan.ts";
import type { Pt, Ring } from "../point.ts";
import { CHORD, SAME } from "../tolerance.ts";
import { radius, roundedUp, toDiameter } from "../units.ts";

/** Areas below this are the chords of two curves that touch, mm². */
const REAL = 0.01;

/**
 * What of an insert lies across the axis while its tip stands at a distance of `r`: its stretch of z from the tip, and how far
 * it reaches.
 */
function acrossAt(outline: Ring, r: number): { from: number; to: number; reach: number } | null {
  let [from, to, reach] = [Infinity, -Infinity, 0];
  const put = (z: number, beyond: number) => {
    [from, to, reach] = [Math.min(from, z), Math.max(to, z), Math.max(reach, beyond)];
  };
  outline.forEach((p, i) => {
    const q = outline[(i + 1) % outline.length] as Pt;
    const [here, next] = [p.r + r, q.r + r];
    if (here < 0) put(p.z, -here);
    if (here < 0 !== next < 0) put(p.z + ((q.z - p.z) * here) / (here - next), 0);
  });
  return reach > SAME ? { from, to, reach } : null;
}

/**
 * The work turns: what an insert reaches across the axis meets the part on the other side, as in a bore that is narrower than the
 * insert is long. A plan that would is refused with the smallest diameter at which the tip stays clear.
 */
export function clearAcross(plan: Plan, { tool, start, stock }: Setting, role: "startU" | "startV"): Plan {
  const outline = insertOutline(plan.tool ?? tool, CHORD, false);
  const lowest = Math.min(0, ...outline.map((p) => p.r));
  if (!(plan.moves.length > 0) || Math.min(start.r, ...plan.moves.map((m) => m.to.r)) + lowest > -SAME) return plan;
  let from = start;
  // From inside, a rapid through a core that nobody has bored cannot be meant.
  const core = role === "startV" && stock ? [plan.part, ...stock] : [plan.part];
  for (const { to, kind } of plan.moves) {
    const across = acrossAt(outline, Math.min(from.r, to.r));
    const [left, right] = [Math.min(from.z, to.z), Math.max(from.z, to.z)];
    from = to;
    if (!across) continue;
    const met = inBox(kind === "rapid" ? core : [plan.part], {
      left: left + across.from,
      right: right + across.to,
      low: 0,
      high: across.reach,
    });
    if (areaOf(met) < REAL) continue;
    const free = Math.min(...plan.contour.flatMap((s) => [s.from.r, s.to.r]));
    const x = roundedUp(toDiameter(radius(-lowest - free)));
    const refused = issue("insertAcrossAxis", "error",
      x < toDiameter(radius(free)) ? { reach: across.reach, nearest: x } : { reach: across.reach }, role);
    return { ...plan, moves: [], passes: 0, reach: [], kept: [], issues: [...plan.issues, refused] };
  }
  return plan;
}
