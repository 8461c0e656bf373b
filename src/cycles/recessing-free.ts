import { toFlat } from "../kernel/geometry/flat.ts";
import type { Plan, PlanContext } from "../kernel/plan/plan.ts";
import { type Axial, type Diameter, toRadius } from "../kernel/units.ts";
import type { Given, Outline } from "./define.ts";
import { freeOutline, plungeFrame } from "./free-outline.ts";
import { planPlunges, type PlungeValues } from "./recessing-plan.ts";
import { refusedPlan } from "./refused-plan.ts";
import { atParameters } from "./roles.ts";
import { angleIssues, withIssues } from "./tool-issues.ts";

/** The values of a recessing cycle that affect its outline: limits, but no reversed direction. */
interface Limited {
  readonly Q479: number;
  readonly Q480: Diameter;
  readonly Q482: Axial;
}

/** The programmed contour; the tool goes in from its open side, and the part continues past both ends. */
export const freeRecessing = (v: Limited, given: Given, transverse: boolean): Outline => ({
  ...freeOutline({ ...v, Q499: 0 }, given, transverse),
  sunk: true,
});

/** Plans a programmed contour by plunges, in a cylinder or in a face. */
export function planFreeRecessing(
  v: Limited & PlungeValues,
  setting: PlanContext,
  given: Given,
  transverse: boolean,
): Plan {
  const outline = freeRecessing(v, given, transverse);
  const none = refusedPlan(outline);
  if (none) return none;
  const frame = plungeFrame(outline.contour, transverse, setting);
  const limit = v.Q479 === 1 ? toFlat(frame, { r: toRadius(v.Q480), z: v.Q482 }) : null;
  const plan = planPlunges(v, { contour: outline.contour, frame }, limit, setting);
  const found = angleIssues(outline, setting.tool, frame, (_q, direction) => Math.abs(direction));
  return atParameters(withIssues(plan, found), frame, {
    infeed: "Q463",
    overlap: "Q510",
    limitX: "Q480",
    limitZ: "Q482",
  });
}
