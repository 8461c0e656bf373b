import type { Cycle, Given, Group } from "../../cycles/define.ts";
import type { Params, Values } from "../../cycles/params.ts";
import type { Reason } from "../../kernel/plan/issue.ts";
import type { Plan, PlanContext } from "../../kernel/plan/plan.ts";
import type { Segment } from "../../kernel/geometry/point.ts";
import type { Tool, ToolType } from "../../kernel/plan/tool.ts";
import { checkTool } from "./check-tool.ts";

/** A tool with the contour length in mm that its shape cannot reach, its nose radius aside. */
export interface ToolFit {
  readonly tool: Tool;
  readonly makesContour: boolean;
  /** False when no cutting move can be planned. */
  readonly cuts: boolean;
  readonly unreached: number;
}

/** Length along the path, mm; a chord stands for an arc: it only ranks. */
const chord = ({ from, to }: Segment) => Math.hypot(to.z - from.z, to.r - from.r);

/** Reasons that another tool may remove. A limit, a forbidden plunge and an oversize are choices of the cycle. */
const OF_TOOL: ReadonlySet<Reason | null> = new Set<Reason | null>([
  "mainEdge",
  "secondaryEdge",
  "toolWidth",
  "cutLength",
]);

const unreached = (plan: Plan) =>
  plan.reach.reduce((sum, { path, reason }) => sum + (OF_TOOL.has(reason) ? chord(path) : 0), 0);

/** Shorter sections are no reason to change the tool, mm. */
const NEGLIGIBLE = 0.01;

const AGAINST_TOOL = new Set([
  "cornerSmallerThanInsert",
  "recessNarrowerThanTool",
  "angleNotFollowed",
  "toolUnfit",
  "toolCannotCutSideways",
  "flanksNotChecked",
  "toolColumn",
  "offsetOverLimit",
  "nothingToCut",
]);

/** Fit of a tool from its plan. A notice (a reduced infeed) is no obstacle; a warning about the tool is one. */
export function fitOf(tool: Tool, plan: Plan): ToolFit {
  const left = unreached(plan);
  const refused = plan.issues.some(
    ({ code, severity }) => severity === "error" || (severity === "warning" && AGAINST_TOOL.has(code)),
  );
  const cuts = plan.moves.some((move) => move.phase !== "position");
  return { tool, makesContour: !refused && cuts && left < NEGLIGIBLE, cuts, unreached: left };
}

/** Usual tool types per kind of cycle, best first; others come last. */
const USUAL: Readonly<Record<Group, readonly ToolType[]>> = {
  special: [],
  longitudinal: ["ROUGH", "FINISH", "BUTTON", "RECTURN"],
  transverse: ["ROUGH", "FINISH", "BUTTON", "RECTURN"],
  recessTurning: ["RECTURN", "RECESS"],
  recessing: ["RECESS", "RECTURN"],
  thread: ["THREAD"],
};

/** Whether this tool type is usual for a kind of cycle. */
export const isUsualTool = (group: Group, { TYPE }: Tool): boolean => USUAL[group].some((each) => each === TYPE);

/** Rank of a tool in the usual order of a kind of cycle. */
function usualRank(group: Group, { TYPE }: Tool): number {
  const place = USUAL[group].findIndex((each) => each === TYPE);
  return place < 0 ? USUAL[group].length : place;
}

/** Tools in the usual order of a kind of cycle. */
export const usualFirst = (group: Group, tools: readonly Tool[]): readonly Tool[] =>
  tools.toSorted((a, b) => usualRank(group, a) - usualRank(group, b));

/**
 * All tools, best first: those that machine the whole contour in the usual order, then those that cut, by residual
 * length.
 */
export function rankTools<P extends Params>(
  cycle: Cycle<P>,
  values: Values<P>,
  given: Given,
  setting: Omit<PlanContext, "tool">,
  tools: readonly Tool[],
): ToolFit[] {
  return tools
    .filter((tool) => checkTool(tool).length === 0)
    .map((tool) => fitOf(tool, cycle.plan(values, { ...setting, tool }, given)))
    .sort(
      (a, b) =>
        Number(b.makesContour) - Number(a.makesContour) ||
        Number(b.cuts) - Number(a.cuts) ||
        (a.makesContour ? usualRank(cycle.group, a.tool) - usualRank(cycle.group, b.tool) : a.unreached - b.unreached),
    );
}

/** Another tool that machines the whole contour; null without one. */
export function betterTool<P extends Params>(
  cycle: Cycle<P>,
  values: Values<P>,
  given: Given,
  setting: PlanContext,
  tools: readonly Tool[],
): Tool | null {
  const others = tools.filter((tool) => tool.T !== setting.tool.T);
  const best = rankTools(cycle, values, given, setting, others)[0];
  return best?.makesContour ? best.tool : null;
}
