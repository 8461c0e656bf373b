import type { Flat, Frame } from "../kernel/geometry/flat.ts";
import type { Plan, PlanContext } from "../kernel/plan/plan.ts";
import type { Segment } from "../kernel/geometry/point.ts";
import { feedsOf } from "../kernel/strategy/feeds.ts";
import { emptyPlan } from "../kernel/strategy/leveled.ts";
import { planPlunging } from "../kernel/strategy/plunge.ts";
import { type Diameter, type Feed, perSide } from "../kernel/units.ts";
import { finishedRecess, narrowIssue } from "./recess-plan.ts";
import type { RecessOutline } from "./recess-outline.ts";
import { atParameters } from "./roles.ts";
import type { ShoulderValues } from "./shoulder-outline.ts";
import { angleIssues, cornerIssue, withIssues } from "./tool-issues.ts";

/** The values of every recessing cycle besides its contour. */
export interface PlungeValues {
  readonly Q215: number;
  readonly Q460: number;
  readonly Q478: Feed | "auto";
  readonly Q483: Diameter;
  readonly Q484: number;
  readonly Q505: Feed | "auto";
  readonly Q463: number;
  readonly Q510: number;
  readonly Q511: number;
  readonly Q462: number;
  readonly Q211: number;
  readonly Q562: number;
}

/** Plans any contour by plunges. */
export function planPlunges(
  v: PlungeValues,
  on: { readonly contour: readonly Segment[]; readonly frame: Frame },
  limit: Flat | null,
  setting: PlanContext,
): Plan {
  const feeds = feedsOf({ rough: v.Q478, finish: v.Q505 }, setting.autoFeed);
  return planPlunging(
    {
      frame: on.frame,
      contour: on.contour,
      operation: v.Q215,
      clearance: v.Q460,
      finishingFeed: feeds.finish,
      oversize: { r: perSide(v.Q483), z: v.Q484 },
      overlap: v.Q510,
      comb: v.Q562 === 1,
      limit,
      feed: feeds.rough,
      solidFeed: (feeds.rough * v.Q511) / 100,
      bite: v.Q463,
      dwell: v.Q211,
      aslant: v.Q462 === 1,
    },
    setting,
  );
}

/** The finished recess of a cycle with its own contour; its floor is never shifted. */
export const recessingOutline = (v: ShoulderValues, transverse: boolean): RecessOutline =>
  finishedRecess({ ...v, Q509: 0 }, transverse);

/** The path of a recessing cycle with its own contour. */
export function planRecessing(v: ShoulderValues & PlungeValues, outline: RecessOutline, setting: PlanContext): Plan {
  if (outline.contour.length === 0 || outline.issues.length > 0) return emptyPlan(outline.issues, outline.contour);
  const { frame } = outline;
  const { tool } = setting;
  const plan = planPlunges(v, outline, null, setting);
  const angle = (_q: string, direction: number) => 90 - Math.abs(direction);
  const found = [
    ...narrowIssue(outline, v, tool),
    ...cornerIssue(v.Q500, tool),
    ...angleIssues(outline, tool, frame, angle),
  ];
  return atParameters(withIssues(plan, found), frame, {
    infeed: "Q463",
    depth: frame.transverse ? "Q494" : "Q493",
    overlap: "Q510",
  });
}
