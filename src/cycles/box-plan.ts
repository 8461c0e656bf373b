import { toFlat } from "../kernel/geometry/flat.ts";
import type { Plan, PlanContext } from "../kernel/plan/plan.ts";
import { at } from "../kernel/geometry/point.ts";
import { feedsOf } from "../kernel/strategy/feeds.ts";
import { planLeveled } from "../kernel/strategy/leveled.ts";
import { type Axial, type Diameter, type Feed, type Length, perSide, type Radius, toRadius } from "../kernel/units.ts";
import { edgesOf } from "./corner-element.ts";
import { refusedPlan } from "./refused-plan.ts";
import { atParameters } from "./roles.ts";
import type { BoxOutline, ShoulderValues } from "./shoulder-outline.ts";
import { angleIssues, cornerIssue, withIssues } from "./tool-issues.ts";

/** The values of a cycle that cuts a box by levels, besides the box. */
export interface LeveledValues {
  readonly Q215: number;
  readonly Q460: Length;
  readonly Q463: Radius | Axial;
  readonly Q478: Feed | "auto";
  readonly Q483: Diameter;
  readonly Q484: Length;
  readonly Q505: Feed | "auto";
  readonly Q506: number;
}

/** Plans a box by levels: shoulders (81x, 82x) and contours that a tool plunges into. */
export function planBox(outline: BoxOutline, v: LeveledValues & ShoulderValues, setting: PlanContext): Plan {
  const none = refusedPlan(outline);
  if (none) return none;
  const { frame } = outline;
  const plan = planLeveled(
    {
      frame,
      contour: outline.contour,
      edges: edgesOf(outline.names, "Q502", "Q504"),
      operation: v.Q215,
      clearance: v.Q460,
      infeed: v.Q463,
      feeds: feedsOf({ rough: v.Q478, finish: v.Q505 }, setting.autoFeed),
      oversize: { r: perSide(v.Q483), z: v.Q484 },
      plunging: true,
      smoothing: v.Q506,
      limit: null,
      outerHeight: toFlat(frame, at(v.Q492, toRadius(v.Q491))).v,
      // The part in front of a plunging contour is not cut.
      partInFront: outline.sunk,
      startRule: "shoulder",
    },
    setting,
  );
  const tool = [...cornerIssue(v.Q500, setting.tool), ...angleIssues(outline, setting.tool, frame, outline.angleAt)];
  return atParameters(withIssues(plan, tool), frame, { infeed: "Q463" });
}
