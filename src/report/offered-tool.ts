import { cycleByNumber } from "../cycles/index.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import type { Operation } from "../program/state/run-types.ts";
import { betterTool } from "../program/tools/which-tool.ts";

/** Findings that another tool would fix: dimensions of the drawing stay unchanged. */
export const FIXED_BY_TOOL: ReadonlySet<string> = new Set([
  "toolUnfit",
  "toolCannotCutSideways",
  "recessNarrowerThanTool",
  "angleNotFollowed",
  "cornerSmallerThanInsert",
]);

/** Most operations per report for which tools are tried: each costs a plan per tool. */
const MOST = 40;

/**
 * The tool of a table that makes the contour of an operation, by trial; null without one. A loop over a call is tried
 * once.
 */
export function toolSuggester(tools: readonly Tool[]): (operation: Operation) => Tool | null {
  const known = new Map<string, Tool | null>();
  return ({ cycle: number, tool, call, feedUnit, definedFile, definedLine }) => {
    const cycle = cycleByNumber(number),
      key = `${definedFile ?? ""} ${definedLine} ${tool.T}`;
    const before = known.get(key);
    if (before !== undefined) return before;
    if (!cycle || !call || known.size >= MOST) return null;
    const setting = { tool, start: call.start, feedUnit, autoFeed: call.autoFeed, stock: null };
    const found = betterTool(cycle, call.values, call.given, setting, tools);
    known.set(key, found);
    return found;
  };
}
