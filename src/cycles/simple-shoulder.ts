import type { Plan, Setting } from "../kernel/plan/plan.ts";
import type { Pt } from "../kernel/geometry/point.ts";
import type { Axial, Diameter } from "../kernel/units.ts";
import { type LeveledValues, planBox } from "./box-plan.ts";
import { toldOfStart, atTool, fromStart } from "./from-start.ts";
import { type BoxOutline, shoulderOutline } from "./shoulder-outline.ts";

/** The values of a simple shoulder. */
type Values = LeveledValues & { readonly Q493: Diameter; readonly Q494: Axial };

/** The square shoulder between a start point and an end point. */
export const simpleShoulder = (v: Values, start: Pt | null, transverse: boolean): BoxOutline =>
  toldOfStart(shoulderOutline(fromStart(v, start), transverse));

/** Its plan: the box begins at the tip at the call. */
export function planSimple(v: Values, setting: Setting, transverse: boolean): Plan {
  const plan = planBox(simpleShoulder(v, setting.start, transverse), fromStart(v, setting.start), setting);
  return { ...plan, issues: atTool(plan.issues) };
}
