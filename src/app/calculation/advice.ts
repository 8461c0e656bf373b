import type { ShapeRequest } from "../../cycles/shape-request.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { SetJob } from "../../program/job/job.ts";
import { tipAtCall } from "../../program/job/requested-job.ts";
import type { ToolFit } from "../../program/tools/which-tool.ts";
import { remedies, type Remedy } from "../../report/remedies.ts";
import { tryWay, type TriedOption } from "../../report/which/try-way.ts";
import { waysFor, type Proposal } from "../../report/which/ways.ts";
import type { Residual } from "../../sim/simulation.ts";
import { parse } from "../../nc/parse.ts";
import {
  searchOf,
  triedWay,
  type BetterWay,
  type Candidate,
  type Search,
} from "../../report/better-ways/better-ways.ts";
import type { Baseline } from "../../report/better-ways/judge.ts";
import type { Conditions } from "../../report/better-ways/situation.ts";
import { variantsOf, type Variants } from "./variants.ts";
import { engine, type CalledCycle } from "./engine.ts";
import type { Request } from "./request.ts";

let newest: { readonly of: string; readonly variants: Variants } | null = null;

/** The variants of a program: those of the newest are kept for its next try. */
function variants(request: Request): Variants {
  const of = JSON.stringify(request);
  if (newest?.of !== of) newest = { of, variants: variantsOf(request) };
  return newest.variants;
}

/**
 * Slow calculations that run only on request, as pure functions of plain data. They run in the worker, which fetches
 * them on first use.
 */
export const advice = {
  /** What each tool can do with the values of a work that has not been run, from its own start point. */
  fitsOfWork(job: SetJob, tools: readonly Tool[]): readonly ToolFit[] | null {
    return engine.fits(job, { start: tipAtCall(job), feedUnit: job.perRevolution ? "mm/rev" : "mm/min", tools });
  },

  /** The operations that could make a shape, to be tried one by one. */
  ways(wanted: ShapeRequest, stock: readonly Ring[] | null, tools: readonly Tool[]): readonly Proposal[] {
    return waysFor(wanted, stock, tools);
  },

  /** Simulates one of them. */
  tryWay(
    proposal: Proposal,
    wanted: ShapeRequest,
    stock: readonly Ring[] | null,
    shop: Pick<Request, "table" | "rapid" | "control" | "machine">,
  ): TriedOption {
    const { table, rapid, control, machine } = shop;
    return tryWay(proposal, wanted, stock, { ...table, rapid, control, ...(machine && { machine }) });
  },

  /** Tools that would remove the residual material of a call, the one with the least left first. */
  remediesOf(called: CalledCycle, left: Residual, tools: readonly Tool[]): readonly Remedy[] {
    return remedies(tools)(called, left);
  },

  /** The changes of a program that may be better, to be tried one by one. */
  searchBetterWays(request: Request, conditions: Omit<Conditions, "tools">): Search {
    const { tools } = request.table;
    return searchOf(parse(request.text), variants(request).attempt, { ...conditions, tools });
  },

  /** Runs one of them, and simulates it where that can decide; null unless it is better. */
  tryBetterWay(candidate: Candidate, baseline: Baseline, request: Request): BetterWay | null {
    return triedWay(candidate, baseline, variants(request).trial(candidate.text));
  },
};
