import type { Site } from "../../cycles/shape-request.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { Operation, Run } from "../../program/state/run-types.ts";
import type { WhichRegion } from "../place/place.ts";

/** The side from which an operation works. */
export function siteOfOperation({ plan: { openSide } }: Operation): Site {
  if (Math.abs(openSide.z) > Math.abs(openSide.r)) return "face";
  return openSide.r < 0 ? "inside" : "outside";
}

/** The whole contour of the operation at a step of a run, or of the last one; null if it has none. */
export function contourAt(run: Run, step: number, stock: readonly Ring[] = []): WhichRegion | null {
  const operation = run.operations[run.steps[step]?.operation ?? run.operations.length - 1];
  const contour = operation?.plan.contour ?? [];
  if (!operation || contour.length === 0) return null;
  return {
    contour,
    first: 0,
    last: contour.length - 1,
    site: siteOfOperation(operation),
    stock,
    initialStock: "solid",
  };
}
