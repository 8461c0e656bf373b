import { difference, offset, union } from "../kernel/area/clip.ts";
import { at, part, type Ring } from "../kernel/geometry/point.ts";
import { CHORD, SLIVER } from "../kernel/tolerance.ts";
import { producedParts } from "./produced-parts.ts";
import type { SimulatedOperation, Simulation } from "./simulation.ts";

/** The union of the machining areas of all operations. */
export const machiningArea = (operations: readonly SimulatedOperation[]): Ring[] =>
  union(operations.map((o) => o.plan.area));

/** What a contour in a bore encloses: nothing of the part stands between it and the axis. */
function boreOf({ plan: { contour, openSide } }: SimulatedOperation): Ring[] {
  const points = part.flattenedChain(contour, CHORD);
  const [first, last] = [points[0], points.at(-1)];
  return openSide.r < 0 && first && last ? [[at(first.z, 0), ...points, at(last.z, 0)]] : [];
}

/**
 * The finished part as far as the operations define it, shrunk by SLIVER for the chord errors of tools and contours.
 * One operation's area may lie inside the part of an earlier one: a groove in a turned cylinder.
 */
export function finishedPart(operations: readonly SimulatedOperation[]): Ring[] {
  const parts = union(operations.map((o) => o.plan.part));
  const cut = [...machiningArea(operations), ...operations.flatMap(boreOf)];
  return parts.length === 0 ? [] : offset(difference(parts, cut), -SLIVER);
}

/** Missing material below this is chord error of both sides, mm. */
const MISSING = 2 * SLIVER;

/** A finished part less what feed moves outside cycles cut from it on purpose. */
export function lessPlainCuts(finished: readonly Ring[], simulation: Simulation): readonly Ring[] {
  const kept = union([...producedParts(simulation), ...simulation.findings.flatMap((f) => offset(f.rings, MISSING))]);
  const gone = offset(difference(finished, kept), -MISSING / 2);
  return gone.length === 0 ? finished : difference(finished, offset(gone, MISSING / 2 + CHORD));
}
