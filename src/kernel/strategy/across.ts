import { areaOf } from "../area/area.ts";
import { boxAround, inBox } from "../area/box.ts";
import { intersection } from "../area/clip.ts";
import { holderOutlines } from "../cutter/holder.ts";
import { hullOf } from "../cutter/hull.ts";
import { insertOutline } from "../cutter/insert.ts";
import { REAL_AREA } from "../area/real-area.ts";
import { issue, type Issue } from "../plan/issue.ts";
import type { Move } from "../plan/move.ts";
import type { Plan, PlanContext } from "../plan/plan.ts";
import { at, part, type Pt, type Ring } from "../geometry/point.ts";
import { CHORD, SAME } from "../tolerance.ts";
import { radius, rounded, toDiameter } from "../units.ts";

/**
 * The part of an insert beyond the axis while its tip is at a distance of `r`: its range of z from the tip, and its
 * greatest reach.
 */
function overlapAcrossAxis(outline: Ring, r: number): { from: number; to: number; reach: number } | null {
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

/** The area that a convex outline sweeps beyond the axis on a straight move, mirrored to this side. */
function sweptAcross(outline: Ring, from: Pt, to: Pt): Ring[] {
  const turned = [from, to].flatMap((p) => outline.map((q) => [q.z + p.z, -(q.r + p.r)] as const));
  return inBox([hullOf(turned).map(([z, r]) => at(z, r))], {
    left: -Infinity,
    right: Infinity,
    low: 0,
    high: Infinity,
  });
}

/** End points of a move in straight steps. */
const waypoints = (from: Pt, m: Move): readonly Pt[] =>
  m.kind === "arc"
    ? part.flattened({ kind: "arc", from, to: m.to, centre: m.centre, turn: m.turn }, CHORD).slice(1)
    : [m.to];

/** The plan without its path, with the reason as an issue. */
const withoutPath = (plan: Plan, found: Issue): Plan => ({
  ...plan,
  moves: [],
  passes: 0,
  reach: [],
  oversizeReach: [],
  issues: [...plan.issues, found],
});

/**
 * The workpiece rotates: the part of an insert beyond the axis meets the part on the other side, as in a bore that is
 * narrower than the insert is long. Such a plan is refused with the smallest diameter at which the tip stays clear. A
 * plan that bores without a bore is refused as well.
 */
export function withAxisCheck(plan: Plan, setting: PlanContext, role: "startU" | "startV"): Plan {
  const { tool, start } = setting;
  const outline = insertOutline(plan.tool ?? tool, CHORD, false);
  const lowest = Math.min(0, ...outline.map((p) => p.r));
  if (!(plan.moves.length > 0)) return plan;
  const missing = role === "startV" && plan.openSide.r < 0 ? boreMissing(plan, setting, lowest) : null;
  if (missing) return withoutPath(plan, missing);
  if ([start, ...plan.moves.map((m) => m.to)].every(({ r }) => r + lowest > -SAME)) return plan;
  let from = start;
  for (const to of plan.moves.flatMap((m, i) => waypoints(plan.moves[i - 1]?.to ?? start, m))) {
    const across = overlapAcrossAxis(outline, Math.min(from.r, to.r));
    const [left, right] = [Math.min(from.z, to.z), Math.max(from.z, to.z)];
    const way = [from, to] as const;
    from = to;
    if (!across) continue;
    const near = inBox([plan.part], { left: left + across.from, right: right + across.to, low: 0, high: across.reach });
    if (areaOf(near) < REAL_AREA || areaOf(intersection(sweptAcross(outline, ...way), near)) < REAL_AREA) continue;
    const free = Math.min(...plan.contour.flatMap((s) => [s.from.r, s.to.r]));
    const x = wholeAbove(toDiameter(radius(-lowest - free)));
    return withoutPath(
      plan,
      issue(
        "insertAcrossAxis",
        "error",
        x > 0 && x < toDiameter(radius(free)) ? { reach: across.reach, nearest: x } : { reach: across.reach },
        role,
      ),
    );
  }
  return plan;
}

/** Shorter pieces of a core are rounding errors of an outline, mm. */
const CORE = 0.1;

/** The next larger size that an operator would type. */
const wholeAbove = (d: number) => Math.ceil(d - SAME);

/**
 * The issue of a path inside the workpiece that runs into solid material: to the axis, or so near to it that a core is
 * left for the shank to hit. `lowest`: reach of the insert from the tip towards the axis and beyond.
 */
function boreMissing(plan: Plan, { tool, start, solid }: PlanContext, lowest: number): Issue | null {
  const cuts = plan.moves.flatMap((m, i) => (m.kind === "rapid" ? [] : [plan.moves[i - 1]?.to ?? start, m.to]));
  if (!solid || cuts.length === 0) return null;
  const zs = cuts.map((p) => p.z);
  const [left, right] = [Math.min(...zs), Math.min(Math.max(...zs), solid.below)];
  if (right - left < CORE) return null;
  for (const high of solid.isBored ? [SAME] : [SAME, start.r + lowest - SAME]) {
    const core = high > 0 ? boxAround(inBox(solid.rings, { left, right, low: 0, high })) : null;
    if (core === null || !(core.right - core.left > CORE)) continue;
    const inside = holderOutlines(plan.tool ?? tool)
      .flat()
      .filter((p) => Math.abs(p.z) < right - left);
    const across = Math.max(-lowest, ...inside.map((p) => -p.r)) - start.r;
    const need = across > start.r ? radius(wholeAbove(across)) : start.r;
    const [z, to] = start.z > (left + right) / 2 ? [core.right, left] : [core.left, right];
    return issue("boreMissing", "error", { z: rounded(z), to: rounded(to), need: toDiameter(need) }, "start.x");
  }
  return null;
}
