import type { Plan } from "../kernel/plan/plan.ts";
import { emptyPlan } from "../kernel/strategy/leveled.ts";
import type { Outline } from "./define.ts";

/**
 * A plan with issues and no moves, for values without a contour or with one that cannot be cut. Null when the contour
 * can be planned.
 */
export const refusedPlan = ({ contour, issues }: Outline): Plan | null =>
  contour.length === 0 || issues.length > 0 ? emptyPlan(issues, contour) : null;
