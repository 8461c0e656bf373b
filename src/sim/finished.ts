import { difference, offset, union } from "../kernel/area/clip.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import { CHORD, SLIVER } from "../kernel/tolerance.ts";
import { producedParts } from "./produced-parts.ts";
import type { SimulatedOperation, Simulation } from "./simulation.ts";

/** The union of the machining areas of all operations. */
export const machiningArea = (operations: readonly SimulatedOperation[]): Ring[] =>
  union(operations.map((o) => o.plan.area));

/**
 * The finished part as far as the operations define it, shrunk by SLIVER for the chord errors of tools and contours.
 * One operation's area may lie inside the part of an earlier one: a groove in a turned cylinder.
 */
export function finishedPart(operations: readonly SimulatedOperation[]): Ring[] {
  const parts = union(operations.map((o) => o.plan.part));
  return parts.length === 0 ? [] : offset(difference(parts, machiningArea(operations)), -SLIVER);
}

/** Missing material below this is chord error of both sides, mm. */
const MISSING = 2 * SLIVER;

/** A finished part less what feed moves outside cycles cut from it on purpose. */
export function lessPlainCuts(part: readonly Ring[], simulation: Simulation): readonly Ring[] {
  const kept = union([...producedParts(simulation), ...simulation.findings.flatMap((f) => offset(f.rings, MISSING))]);
  const gone = offset(difference(part, kept), -MISSING / 2);
  return gone.length === 0 ? part : difference(part, offset(gone, MISSING / 2 + CHORD));
}
