import type { ShopRules } from "./types.ts";

/**
 * Costs of the rules of the trade where a shop states none: a change is the tool change of a common turret with its
 * approach, a broken rule costs some passes.
 */
export const USUAL_RULES: ShopRules = {
  toolChange: 10,
  usualTool: 30,
  finishBeforeRough: 60,
  insideBeforeOutside: 30,
  thinBeforeLong: 30,
  tolerancedLast: 30,
  allowance: { diameter: 0.8, z: 0.2 },
};
