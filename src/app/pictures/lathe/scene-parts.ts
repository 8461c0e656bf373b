import { axial, diameter, radius, toRadius } from "../../../kernel/units.ts";
import type { Pt } from "../../../kernel/geometry/point.ts";
import type { PartialWork } from "../../../program/job/partial-work.ts";
import type { Run } from "../../../program/state/run-types.ts";
import type { SceneParts } from "../../../view/scene.ts";

/** Scene parts of a run. */
export const partsOf = (run: Run): SceneParts => ({
  blank: run.blank,
  clamping: run.clamping,
  contours: run.operations.map((o) => o.plan.contour),
  steps: run.steps,
});

/** Scene parts known without a run: blank, contour as far as typed, and the start of the tool. */
export function knownParts({ blank, start, tool, outline, points }: PartialWork, run: Run): Partial<SceneParts> {
  const { contour, sketch, positions } = outline;
  const alone = positions.map(({ axis, value }): Pt =>
    axis === "x" ? { z: axial(0), r: toRadius(diameter(value)) } : { z: axial(value), r: radius(0) },
  );
  const framedPoints = [...points, ...alone];
  const parkedTool = start && run.steps.length === 0 ? { at: start, tool } : null;
  return { contours: [contour], sketch, framedPoints, parkedTool, ...(run.blank.length === 0 && { blank }) };
}
