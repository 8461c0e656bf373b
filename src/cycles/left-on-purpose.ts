import type { IntendedResidual } from "../kernel/plan/plan.ts";
import type { Cycle } from "./define.ts";
import type { Params, Values } from "./params.ts";

/** Operations that leave the oversize: roughing alone, and finishing to oversize. */
const TO_OVERSIZE: readonly number[] = [1, 3];

/**
 * Material that the values of a cycle leave intentionally: the oversize of roughing alone or of finishing to oversize,
 * and the nose radius in a corner without a radius. Programmed contours may require any corner.
 */
export function leftOnPurposeOf({ params, contour, group }: Cycle, values: Values<Params>): IntendedResidual {
  const valueOf = (text: string) => {
    const q = Object.keys(params).find((name) => params[name]?.text === text);
    return q === undefined ? undefined : values[q];
  };
  const operation = valueOf("operation");
  return {
    oversize: typeof operation === "number" && TO_OVERSIZE.includes(operation),
    corner: contour === "own" && group !== "thread" && (valueOf("cornerRadius") ?? 0) === 0,
  };
}
