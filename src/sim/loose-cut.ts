import { intersection, offset } from "../kernel/area/clip.ts";
import { at, type Ring } from "../kernel/geometry/point.ts";
import { REAL_AREA, withoutSlivers } from "../kernel/area/real-area.ts";
import { areaOf } from "../kernel/area/area.ts";
import type { Step } from "../kernel/time/step.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import { merged, type Cutting } from "./cutting.ts";
import type { Loose } from "./work-holding.ts";
import type { Outlines } from "./outlines.ts";
import { plainRun } from "./plain-cut.ts";
import type { SimulatedOperation } from "./simulation.ts";
import { sweptBy } from "./sweep.ts";

/** The tool tip as a small square, mm: the insert behind it may cover the place of a gone piece. */
const SPOT: Ring = [at(-0.02, -0.02), at(0.02, -0.02), at(0.02, 0.02), at(-0.02, 0.02)];
/** Distance at which the remaining stock touches a sweep, mm. */
const AGAINST = 0.02;

/**
 * Whether a feed move cuts loose material: its tip runs inside it, and the area of its operation covers it. A run of
 * plain cuts does when none of it cuts the held part: a tool may pass where a piece was.
 */
export function cutsLoosePiece(
  loose: Loose,
  index: number,
  cut: Cutting,
  {
    steps,
    operations,
    outlines,
  }: {
    readonly steps: readonly Step[];
    readonly operations: readonly SimulatedOperation[];
    readonly outlines: (tool: Tool) => Outlines;
  },
): boolean {
  const step = steps[index] as Step;
  if (withoutSlivers(intersection(loose.inside, sweptBy(SPOT, step).rings)).length === 0) return false;
  const operation = operations[step.operation ?? -1];
  // A bar stop: the tool feeds against a stopped bar and cuts nothing.
  if (!operation && step.spindleFault?.how === "stopped") return false;
  if (operation) return withoutSlivers(intersection(loose.inside, [operation.plan.area])).length > 0;
  const [first, last] = plainRun(steps, index);
  const { insert } = outlines(step.tool);
  const swept = merged(steps.slice(first, last + 1).flatMap((s) => sweptBy(insert, s).rings));
  return areaOf(intersection(offset(swept, AGAINST), cut.stock())) < REAL_AREA;
}
