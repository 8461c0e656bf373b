import type { Cycle, Group } from "../../cycles/define.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import { cuttingWidth } from "../../kernel/cutter/insert.ts";
import { diameter, perSide, roundedUpTo } from "../../kernel/units.ts";
import { never } from "../../kernel/never.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { usualTable } from "../../program/tools/cutting-table.ts";
import type { SetJob } from "../../program/job/job.ts";
import { withCycleValues } from "../../program/job/requested-job.ts";
import { perObject } from "../../nc/per-object.ts";
import type { PlanRequest, ReasonedValue } from "../types.ts";
import { withCuttingValues, type ValuesOfCycle } from "../values/cycle-values.ts";
import { cuttingValues } from "../values/cutting-values.ts";
import { heldWorkpiece } from "../../report/advice/held-workpiece.ts";
import type { HeldBar } from "../../report/advice/stability.ts";
import type { CuttingValues, ValuesRequest, WantedRoughness, Work } from "../values/values-request.ts";

/** Machining operation of a cycle: roughing and finishing, roughing, finishing to size. */
export const OPERATION = { both: 0, rough: 1, finish: 2 } as const;

/** Grid of an infeed, mm. */
const INFEED = 0.05;

/** What the values of an operation depend on besides its cycle and its tool. */
export interface CutRequest {
  readonly operation: keyof typeof OPERATION;
  readonly work: Work;
  /** Smallest and largest diameter that is cut, mm. */
  readonly smallest: number;
  readonly largest: number;
  readonly stock: readonly Ring[];
  /** The finest of its surfaces; absent without a mark. */
  readonly roughness?: WantedRoughness;
  /** Width of a groove, mm: a blade that fills it leaves no oversize on its sides. */
  readonly width?: number;
  /** Depth of a hole or a groove, height of a thread, mm. */
  readonly depth?: number;
  readonly pitch?: number;
  /** The boring bar of an inside cut. */
  readonly bar?: HeldBar | null;
}

/** The usual work of a cycle that cuts outside. */
export const workOf = (group: Group, operation: keyof typeof OPERATION): Work => {
  if (group === "thread") return "thread";
  if (group === "recessing" || group === "recessTurning") return "recess";
  return operation === "finish" ? "finish" : "rough";
};

/** The stiffness of a stock in its clamping is the same for every tool. */
const workpieceIn = perObject(({ clamping }: PlanRequest) =>
  perObject((stock: readonly Ring[]) => heldWorkpiece(stock, clamping)),
);

/** Cutting values of a tool in the stock and the shop of a request, by their formulas. */
export function valuesOf(tool: Tool, cut: CutRequest, request: PlanRequest): CuttingValues {
  const { material: id, shop } = request;
  const { materials, power } = usualTable;
  const material = materials.find((m) => m.id === id.toLowerCase()) ?? materials[0];
  if (!material) return never("a table of cutting data without a material", id);
  const asked: ValuesRequest = {
    work: cut.work,
    tool,
    material,
    smallest: cut.smallest,
    largest: cut.largest,
    workpiece: workpieceIn(request)(cut.stock),
    bar: cut.bar ?? null,
    machine: shop.machine?.spindle ?? null,
    power,
    roughness: cut.roughness ?? null,
    ...(cut.depth !== undefined && { depth: cut.depth }),
    ...(cut.pitch !== undefined && { pitch: cut.pitch }),
  };
  return cuttingValues(asked);
}

/** The values of both works of a cut: several cycles can make it. */
const valuesIn = perObject((request: PlanRequest) =>
  perObject((cut: CutRequest) =>
    perObject((tool: Tool): ValuesOfCycle => {
      const turns = cut.work === "rough" || cut.work === "face" || cut.work === "recess";
      return {
        main: valuesOf(tool, cut, request),
        ...(cut.operation === "both" && turns && { finish: valuesOf(tool, { ...cut, work: "finish" }, request) }),
      };
    }),
  ),
);

/** Sets tool, operation, oversize and cutting values of a job of a cycle, with the reasons for them. */
export function withValues(
  job: SetJob,
  cycle: Cycle,
  tool: Tool,
  cut: CutRequest,
  request: PlanRequest,
): { readonly job: SetJob; readonly values: readonly ReasonedValue[] } {
  const own = valuesIn(request)(cut)(tool);
  const { main } = own;
  const made = withCuttingValues({ ...job, tool: tool.T }, cycle, own);
  const { allowance } = request.rules;
  const leaves = cut.operation !== "finish";
  const isFilled = cut.width !== undefined && cut.width - cuttingWidth(tool) < allowance.z + allowance.z;
  // A finishing pass takes what roughing leaves in a corner.
  const stands = Math.hypot(perSide(diameter(allowance.diameter)), allowance.z);
  const set: Readonly<Record<string, number>> = {
    Q215: OPERATION[cut.operation],
    Q483: leaves ? allowance.diameter : 0,
    Q484: leaves && !isFilled ? allowance.z : 0,
    ...(!leaves && { Q463: roundedUpTo(INFEED, Math.max(stands, main.infeed?.value ?? 0)) }),
  };
  return {
    job: withCycleValues(
      made.job,
      Object.entries(set).filter(([q]) => cycle.params[q]),
    ),
    values: made.values.filter(({ q }) => set[q] === undefined),
  };
}
