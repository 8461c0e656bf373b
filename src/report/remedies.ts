import { cycleByNumber } from "../cycles/index.ts";
import type { Reason } from "../kernel/plan/issue.ts";
import type { Plan } from "../kernel/plan/plan.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import { checkTool } from "../program/tools/check-tool.ts";
import type { Operation as Ran } from "../program/state/run-types.ts";
import { shiftedPlan } from "../program/blocks/shifted-plan.ts";
import { residualAreaAfter } from "../sim/residual.ts";
import type { Residual } from "../sim/simulation.ts";

/** A tool that would take residual material, with what it would leave of it, mm². */
export interface Remedy {
  readonly tool: Tool;
  readonly residualArea: number;
}

/**
 * Residual material that another tool could remove. A limit, a forbidden plunge, an oversize or a tool compensation
 * leaves it with every tool.
 */
const OF_TOOL: ReadonlySet<Reason> = new Set<Reason>([
  "insertRadius",
  "mainEdge",
  "secondaryEdge",
  "toolWidth",
  "cutLength",
]);
/** A tool that leaves more than this share of a region is no remedy. */
const MOST_LEFT = 0.5;
/** Issues that rule out a tool. */
const AGAINST: ReadonlySet<string> = new Set(["toolCannotCutSideways", "flanksNotChecked"]);

/** The operation that left the residual material. */
type Operation = Pick<Ran, "cycle" | "tool" | "feedUnit" | "call">;

/** The plan with another tool: same cycle, same values, same start; null where it is impossible. */
function planWith(tool: Tool, { cycle: number, call, feedUnit }: Operation): Plan | null {
  const cycle = cycleByNumber(number);
  if (!cycle || !call || checkTool(tool).length > 0) return null;
  const plan = shiftedPlan(
    cycle.plan(call.values, { tool, start: call.start, feedUnit, autoFeed: call.autoFeed, stock: null }, call.given),
    call.datum,
  );
  const refused = plan.issues.some((i) => i.severity === "error" || AGAINST.has(i.code));
  return refused || !plan.moves.some((m) => m.phase !== "position") ? null : plan;
}

/**
 * Tools of a table that would remove the residual material of an operation, by trial, the least residue first. Each
 * costs a plan per operation, so call it on demand; plans are cached as long as the function.
 */
export function remedies(tools: readonly Tool[]): (operation: Operation, left: Residual) => Remedy[] {
  const plans = new Map<Operation, readonly (readonly [Tool, Plan])[]>();
  const plansOf = (operation: Operation) => {
    const known = plans.get(operation);
    if (known) return known;
    const made = tools
      .filter((tool) => tool.T !== operation.tool.T)
      .flatMap((tool) => {
        const plan = planWith(tool, operation);
        return plan ? [[tool, plan] as const] : [];
      });
    plans.set(operation, made);
    return made;
  };
  return (operation, left) => {
    if (!OF_TOOL.has(left.reason)) return [];
    return plansOf(operation)
      .map(([tool, plan]): Remedy => ({ tool, residualArea: residualAreaAfter(left.ring, plan, tool) }))
      .filter(({ residualArea }) => residualArea < left.area * MOST_LEFT)
      .sort((a, b) => a.residualArea - b.residualArea || a.tool.T - b.tool.T);
  };
}
