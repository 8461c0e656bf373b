import type { Cycle } from "../../cycles/define.ts";
import type { Site } from "../../cycles/shape-request.ts";
import { noseRadius } from "../../kernel/cutter/insert.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { Box } from "../../kernel/geometry/segments.ts";
import type { SetJob } from "../../program/job/job.ts";
import { checkTool } from "../../program/tools/check-tool.ts";
import { fitOf, type ToolFit } from "../../program/tools/which-tool.ts";
import type { Action, ActionKind, PlanRequest } from "../types.ts";
import { planOf } from "./contour-job.ts";
import { withValues, type CutRequest } from "./values-of-job.ts";

/** A cycle on a section, before a tool is chosen. */
export interface Candidate {
  readonly kind: ActionKind;
  readonly site: Site;
  readonly cycle: Cycle;
  readonly job: SetJob;
  readonly cut: CutRequest;
  readonly box: Box;
  /** Tells candidates of one cycle in one place apart. */
  readonly variant?: string;
  /** Most tools to try. */
  readonly most: number;
}

/** Tools that may be used, checked once for a table. */
export const toolsOf = ({ shop, withoutTools }: PlanRequest): readonly Tool[] =>
  shop.tools.filter((tool) => !withoutTools.includes(tool.T) && checkTool(tool).length === 0);

/** The tools with which a candidate cuts something, those that reach most of its contour first. */
export function actionsOf(
  candidate: Candidate,
  tools: readonly Tool[],
  request: PlanRequest,
  better: (a: ToolFit, b: ToolFit) => number = () => 0,
): readonly Action[] {
  const { cycle, kind, site, job, cut, box, variant, most } = candidate;
  return tools
    .flatMap((tool) => {
      const valued = withValues(job, cycle, tool, cut, request);
      const plan = planOf(cycle, valued.job, tool);
      const fit = plan && fitOf(tool, plan);
      const refused = plan?.issues.some(({ severity }) => severity === "error") ?? true;
      return fit?.cuts && !refused ? [{ ...fit, ...valued }] : [];
    })
    .toSorted(
      (a, b) =>
        Number(b.makesContour) - Number(a.makesContour) ||
        better(a, b) ||
        Math.round(10 * (a.unreached - b.unreached)) ||
        noseRadius(b.tool) - noseRadius(a.tool) ||
        a.tool.T - b.tool.T,
    )
    .slice(0, most)
    .map(({ tool, job: made, values }) => ({
      kind,
      key: [kind, cycle.number, `T${tool.T}`, box.right.toFixed(2), box.left.toFixed(2), variant ?? ""].join(" "),
      site,
      tool,
      cycle: cycle.number,
      job: made,
      place: { front: box.right, rear: box.left, high: box.high, low: box.low },
      threads: [],
      values,
    }));
}
