import type { Cycle } from "../../cycles/define.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { SetJob } from "../../program/job/job.ts";
import type { PlanRequest, ReasonedValue } from "../types.ts";

/** Machining operation of a cycle: roughing and finishing, roughing, finishing to size. */
export const OPERATION = { both: 0, rough: 1, finish: 2 } as const;

/** What the values of an operation depend on besides its cycle and its tool. */
export interface CutRequest {
  readonly operation: keyof typeof OPERATION;
  /** Greatest mean roughness of its surfaces, µm; absent without a mark. */
  readonly roughness?: number;
}

/** A job with its tool and its values for cutting, and the reasons for them. */
export interface ValuedJob {
  readonly job: SetJob;
  readonly values: readonly ReasonedValue[];
}

/** Sets tool, operation, oversize and cutting values of a job. */
export function withValues(
  job: SetJob,
  cycle: Cycle,
  tool: Tool,
  { operation }: CutRequest,
  { rules: { allowance } }: PlanRequest,
): ValuedJob {
  const leaves = operation !== "finish";
  const set: Readonly<Record<string, number>> = {
    Q215: OPERATION[operation],
    Q483: leaves ? allowance.diameter : 0,
    Q484: leaves ? allowance.z : 0,
  };
  const known = Object.entries(set).filter(([q]) => cycle.params[q]);
  const draft = { ...job.drafts[cycle.number], ...Object.fromEntries(known.map(([q, n]) => [q, String(n)])) };
  return { job: { ...job, tool: tool.T, drafts: { ...job.drafts, [cycle.number]: draft } }, values: [] };
}
