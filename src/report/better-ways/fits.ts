import { cutLength, cuttingWidth, isBar, noseRadius, tipDirection } from "../../kernel/cutter/insert.ts";
import type { Plan } from "../../kernel/plan/plan.ts";
import { part, type Pt } from "../../kernel/geometry/point.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { checkTool } from "../../program/tools/check-tool.ts";
import { FEED_OF_WIDTH } from "../../program/tools/cutting-work.ts";
import { fitOf, isUsualTool } from "../../program/tools/which-tool.ts";
import { EDGE_USED, FEED_OF_NOSE } from "../advice/formulas.ts";
import { calledNumber, type ProgramSituation, type TurningUnit } from "./situation.ts";

/** Another tool for an operation, planned with its values. */
export interface Fit {
  readonly tool: Tool;
  readonly makesContour: boolean;
  /** Expected time of the operation with it, s. */
  readonly seconds: number;
}
export type Fits = (of: TurningUnit) => readonly Fit[];

/** Most plans of one search. */
const MOST_PLANS = 600;
/** Most material that a finishing insert takes, mm per side. */
const FINISHING_DEPTH = 1;
/** Lateral turning with a blade: depth and feed as a share of its width (Ingersoll, turning and grooving, 2011). */
const BLADE = { depth: 0.8, feed: 0.075 } as const;

/** The feed that an insert bears by its nose, and a blade by its width, mm/rev. */
export const borneFeed = (tool: Tool): number =>
  isBar(tool)
    ? Math.min(FEED_OF_WIDTH * cuttingWidth(tool), noseRadius(tool) || Infinity)
    : FEED_OF_NOSE * noseRadius(tool);

/** Turns of the spindle that the feeds of a plan take, or minutes where it feeds per minute. */
export function feedTurns({ moves }: Plan, start: Pt): number {
  let [from, turns] = [start, 0];
  for (const move of moves) {
    if ((move.kind === "feed" || move.kind === "arc") && move.feed > 0) turns += part.apart(from, move.to) / move.feed;
    from = move.to;
  }
  return turns;
}

/** The material that a plan roughs, mm along its infeed. */
export const depthOf = ({ passes, infeed }: Plan): number => passes * infeed;

/** Whether a tool of this kind does this work: finishing inserts do not rough, roughing inserts do not finish. */
export function suitsWork(of: TurningUnit, tool: Tool, depth: number, work = of.work): boolean {
  const { tool: own } = of.operation;
  if (isBar(tool) !== isBar(own) || !isUsualTool(of.cycle.group, tool)) return false;
  if (Math.sign(tipDirection(tool.TO).v) !== Math.sign(tipDirection(own.TO).v)) return false;
  if (work === "finish") return tool.TYPE !== "ROUGH" || own.TYPE === "ROUGH";
  return tool.TYPE !== "FINISH" || own.TYPE === "FINISH" || depth <= FINISHING_DEPTH;
}

/** Whether depth and feed of a plan are within what an insert takes. */
function bears(of: TurningUnit, tool: Tool, { infeed }: Plan): boolean {
  const feed = of.operation.feedUnit === "mm/rev" && of.work !== "finish" ? calledNumber(of, "roughingFeed") : null;
  if (isBar(tool)) {
    const width = cuttingWidth(tool);
    return (of.cycle.group !== "recessTurning" || infeed <= BLADE.depth * width) && (feed ?? 0) <= BLADE.feed * width;
  }
  const edge = cutLength(tool);
  return (feed ?? 0) <= FEED_OF_NOSE * noseRadius(tool) && (edge === undefined || infeed <= EDGE_USED * edge);
}

/** Plans operations with the other tools that the program calls, each operation once. */
export function fitter({ tools, uses }: Pick<ProgramSituation, "tools" | "uses">): Fits {
  const known = new Map<number, readonly Fit[]>();
  const used = new Set(uses.tools);
  const called = tools.filter((tool) => used.has(tool.T) && checkTool(tool).length === 0);
  let plans = 0;
  const fitsOf = (of: TurningUnit): readonly Fit[] => {
    const { cycle, operation, call } = of;
    if (cycle.group === "thread") return [];
    const { tool: own, feedUnit, plan, seconds } = operation;
    const turns = feedTurns(plan, call.start);
    return called
      .filter((tool) => tool.T !== own.T && isUsualTool(cycle.group, tool))
      .flatMap((tool): readonly Fit[] => {
        plans += 1;
        if (plans > MOST_PLANS) return [];
        const made = cycle.plan(
          call.values,
          { tool, start: call.start, feedUnit, autoFeed: call.autoFeed, stock: null },
          call.given,
        );
        const { cuts, makesContour } = fitOf(tool, made);
        if (!cuts || !suitsWork(of, tool, depthOf(made)) || !bears(of, tool, made)) return [];
        const share = turns > 0 ? feedTurns(made, call.start) / turns : 1;
        return [{ tool, makesContour, seconds: seconds * share }];
      });
  };
  return (of) => {
    const before = known.get(of.unit);
    if (before) return before;
    const found = fitsOf(of);
    known.set(of.unit, found);
    return found;
  };
}
