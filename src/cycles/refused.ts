import type { Plan } from "../kernel/plan/plan.ts";
import { empty } from "../kernel/strategy/leveled.ts";
import type { Outline } from "./define.ts";

/**
 * The plan of values that describe no contour, or one that cannot be cut: nothing but its reasons. Null when there is
 * one to plan.
 */
export const refused = ({ contour, issues }: Outline): Plan | null =>
  contour.length === 0 || issues.length > 0 ? empty(issues, contour) : null;
