import { toFlat } from "../kernel/geometry/flat.ts";
import { mirroredTool } from "../kernel/cutter/holder.ts";
import type { Plan, PlanContext } from "../kernel/plan/plan.ts";
import { feedsOf } from "../kernel/strategy/feeds.ts";
import { planLeveled } from "../kernel/strategy/leveled.ts";
import { type Feed, perSide, toRadius } from "../kernel/units.ts";
import type { LeveledValues } from "./box-plan.ts";
import type { Given } from "./define.ts";
import { frameAt, freeOutline, type FreeValues } from "./free-outline.ts";
import { refusedPlan } from "./refused-plan.ts";
import { atParameters } from "./roles.ts";
import { angleIssues, withIssues } from "./tool-issues.ts";

/** The values of a cycle that cuts a free contour by levels. */
interface FreeLeveled extends LeveledValues, FreeValues {
  readonly Q487: number;
  readonly Q488: Feed | "auto";
}

/** Plans the contour of a subprogram by levels, along the axis or across it. */
export function planFree(v: FreeLeveled, setting: PlanContext, given: Given, transverse: boolean): Plan {
  const outline = freeOutline(v, given, transverse);
  const none = refusedPlan(outline);
  if (none) return none;
  const frame = frameAt(outline.contour, transverse, setting);
  const tool = v.Q499 === 2 ? mirroredTool(setting.tool, transverse ? "r" : "z") : setting.tool;
  const plan = planLeveled(
    {
      frame,
      contour: outline.contour,
      edges: { start: 0, end: 0 },
      operation: v.Q215,
      clearance: v.Q460,
      infeed: v.Q463,
      feeds: feedsOf({ rough: v.Q478, finish: v.Q505, plunge: v.Q488 }, setting.autoFeed),
      oversize: { r: perSide(v.Q483), z: v.Q484 },
      plunging: v.Q487 === 1,
      smoothing: v.Q506,
      limit: v.Q479 === 1 ? toFlat(frame, { r: toRadius(v.Q480), z: v.Q482 }) : null,
      outerHeight: null,
      partInFront: false,
      startRule: "contour",
    },
    { ...setting, tool },
  );
  const found = angleIssues(outline, tool, frame, (_q, direction) => Math.abs(direction));
  const adapted = tool === setting.tool ? plan : { ...plan, tool };
  return atParameters(withIssues(adapted, found), frame, { infeed: "Q463", limitX: "Q480", limitZ: "Q482" });
}
