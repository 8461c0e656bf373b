import { difference, offset, union } from "../kernel/clip.ts";
import type { Ring } from "../kernel/point.ts";
import { SLIVER } from "../kernel/tolerance.ts";
import type { SimulatedOperation } from "./simulation.ts";

/** Everything that the operations together take away when they are perfect. */
export const machiningArea = (operations: readonly SimulatedOperation[]): Ring[] => union(operations.map((o) => o.plan.area));

/**
 * The finished part as far as the operations know it, shrunk by SLIVER because tools and contours both carry a chord
 * error. What one operation takes away may lie inside the part of an earlier one: a groove in a turned cylinder.
 */
export function finishedPart(operations: readonly SimulatedOperation[]): Ring[] {
  const parts = union(operations.map((o) => o.plan.part));
  return parts.length === 0 ? [] : offset(difference(parts, machiningArea(operations)), -SLIVER);
}
