import type { Plan, PlanContext } from "../kernel/plan/plan.ts";
import type { Pt } from "../kernel/geometry/point.ts";
import type { Axial, Diameter } from "../kernel/units.ts";
import { type LeveledValues, planBox } from "./box-plan.ts";
import { withStartPointIssues, angleIssuesAtTool, extendedValues } from "./from-start.ts";
import { type BoxOutline, shoulderOutline } from "./shoulder-outline.ts";

/** The values of a simple shoulder. */
type Values = LeveledValues & { readonly Q493: Diameter; readonly Q494: Axial };

/** The square shoulder between a start point and an end point. */
export const simpleShoulder = (v: Values, start: Pt | null, transverse: boolean): BoxOutline =>
  withStartPointIssues(shoulderOutline(extendedValues(v, start), transverse));

/** Its plan: the box begins at the tip at the call. */
export function planSimple(v: Values, setting: PlanContext, transverse: boolean): Plan {
  const plan = planBox(simpleShoulder(v, setting.start, transverse), extendedValues(v, setting.start), setting);
  return { ...plan, issues: angleIssuesAtTool(plan.issues) };
}
