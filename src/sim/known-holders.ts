import { boxAround } from "../kernel/area/box.ts";
import { insertedLength, isDrill } from "../kernel/cutter/drill.ts";
import type { SimulationInput } from "./simulation.ts";

/**
 * Tools that moved and whose holder is not known, by number. What holds a drill is not described but stands behind its
 * cutting edges: where these never enter as far as the front of any blank, it touches none.
 */
export function unknownHolders({
  steps,
  blank,
  stated = [],
}: Pick<SimulationInput, "steps" | "blank" | "stated">): ReadonlySet<number> {
  const stocks = [blank, ...stated.map(({ rings }) => rings)].filter((rings) => rings.length > 0);
  const front = stocks.length > 0 ? Math.max(...stocks.map((rings) => boxAround(rings).right)) : Infinity;
  const unknown = steps.filter(
    ({ tool, from, move }) =>
      !tool.holder && !(isDrill(tool) && Math.min(from.z, move.to.z) + insertedLength(tool) > front),
  );
  return new Set(unknown.map(({ tool }) => tool.T));
}
