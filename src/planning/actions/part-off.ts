import { boxAround, inBox } from "../../kernel/area/box.ts";
import { at, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import { cuttingWidth } from "../../kernel/cutter/insert.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { radius, toDiameter } from "../../kernel/units.ts";
import { canDo, handCut, wallOf, type HandWork } from "../../program/edits/hand-operation.ts";
import { catalogue } from "../../cycles/index.ts";
import { exampleJob } from "../../program/job/job.ts";
import { cylinderAround } from "../../program/job/requested-shape.ts";
import type { StockSurface } from "../../program/job/stock-surface.ts";
import { withCuttingValues } from "../values/cycle-values.ts";
import type { Action, ActionSource, PlanRequest } from "../types.ts";
import { notDone, toolsOf } from "./candidates.ts";
import { highest, outsideWork } from "./outside-work.ts";
import { valuesOf } from "./values-of-job.ts";

/** Stock beside the blade that its start point has to clear, mm. */
const BESIDE = 1;

/** The chamfer of 45° at the rear edge of a part, mm; 0 without one. */
function rearChamfer(last: Segment | undefined): number {
  if (last?.kind !== "line") return 0;
  const [dz, dr] = [last.from.z - last.to.z, last.from.r - last.to.r];
  return dz > SAME && Math.abs(dz - dr) < SAME ? dz : 0;
}

/** Where a blade of a width parts off, with what it cuts through: outer radius and wall, mm. */
export function parting(stock: readonly Ring[], rear: number, width: number) {
  const left = rear - width;
  const high = highest(stock, left - BESIDE, rear + BESIDE);
  const surface: StockSurface = { site: "outside", from: at(rear, high), to: at(left, high) };
  // A bore that goes farther than the blade leaves a wall.
  const here = inBox(stock, { left, right: rear, low: 0, high });
  return { surface, here, left, high, depth: wallOf(here, surface) };
}

/** The blades that go through the stock: the own ones of the operator, the narrowest usual one where none of these does. */
function bladesOf(stock: readonly Ring[], rear: number, request: PlanRequest): readonly Tool[] {
  const able = toolsOf(request).filter((tool) =>
    canDo("partOff", tool, { isInside: false, depth: parting(stock, rear, cuttingWidth(tool)).depth }),
  );
  const own = able.filter(({ T }) => !request.usualTools?.includes(T));
  return own.length > 0 ? own : able.slice(0, 1);
}

/** Parts the part off from the bar when it is rough turned, with the chamfer at its rear edge or without. */
export const partOff: ActionSource = {
  kind: "partOff",
  actions(state, request) {
    const { stock } = state;
    const { part: planned, partsOff } = request;
    const rear = boxAround(planned.rings).left;
    if (!partsOff || boxAround(stock).left > rear - SAME) return [];
    if (outsideWork(state, request).rough.some(({ opensAhead }) => opensAhead)) return [];
    const size = rearChamfer(planned.outside.segments.at(-1));
    const works: readonly HandWork[] = size > 0 ? ["partOffChamfered", "partOff"] : ["partOff"];
    const [cycle] = catalogue;
    const actions = bladesOf(stock, rear, request).flatMap((tool) =>
      works.flatMap((work): readonly Action[] => {
        const { surface, here, left, high, depth } = parting(stock, rear, cuttingWidth(tool));
        if (!cycle) return [];
        const largest = toDiameter(radius(high));
        const main = valuesOf(
          tool,
          { operation: "both", work: "partOff", smallest: toDiameter(radius(high - depth)), largest, stock, depth },
          request,
        );
        const { start, cut } = handCut(work, {
          stock: here,
          surface,
          tool,
          sizes: { size, z: rear },
          feed: main.feed.value,
        });
        const base = { ...exampleJob(cycle), tool: tool.T, start, blank: cylinderAround(stock) };
        const { job, values } = withCuttingValues(base, { params: {} }, { main });
        return [
          {
            kind: "partOff",
            key: `partOff ${work} T${tool.T}`,
            site: "outside",
            tool,
            cycle: null,
            job,
            cut,
            place: { front: rear, rear: left, high, low: high - depth },
            threads: [],
            values,
          },
        ];
      }),
    );
    return notDone(actions, state);
  },
};
