import type { Cycle } from "../../cycles/define.ts";
import type { Site } from "../../cycles/shape-request.ts";
import { noseRadius, tipDirection } from "../../kernel/cutter/insert.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { Plan } from "../../kernel/plan/plan.ts";
import type { Box } from "../../kernel/geometry/segments.ts";
import type { Spindle } from "../../kernel/time/step.ts";
import { secondsOf } from "../../kernel/time/time.ts";
import type { SetJob } from "../../program/job/job.ts";
import { tipAtCall } from "../../program/job/requested-job.ts";
import { checkTool } from "../../program/tools/check-tool.ts";
import { fitOf, type ToolFit } from "../../program/tools/which-tool.ts";
import { perObject } from "../../nc/per-object.ts";
import type { Action, ActionKind, PlanRequest, PlanState } from "../types.ts";
import { planOf } from "./contour-job.ts";
import { withValues, type CutRequest } from "./values-of-job.ts";

/** A cycle on a section, before a tool is chosen. */
export interface Candidate {
  readonly kind: ActionKind;
  readonly site: Site;
  readonly cycle: Cycle;
  readonly job: SetJob;
  /** Another job for the same: each tool has the one whose path takes less time. */
  readonly other?: SetJob;
  readonly cut: CutRequest;
  readonly box: Box;
  /** Tells candidates of one cycle in one place apart. */
  readonly variant?: string;
}

/** Tools that may be used, checked once for a table. */
export const toolsOf = perObject(({ shop, withoutTools }: PlanRequest): readonly Tool[] =>
  shop.tools.filter((tool) => !withoutTools.includes(tool.T) && checkTool(tool).length === 0),
);

/** Those of them that do not point away from the axis: outside every cycle refuses the others. */
export const outsideTools = perObject((request: PlanRequest): readonly Tool[] =>
  toolsOf(request).filter(({ TO }) => tipDirection(TO).v <= 0),
);

/** A candidate with a tool: its job with all values, and how far the tool reaches. */
export interface Fitted extends ToolFit {
  readonly plan: Plan;
  readonly job: SetJob;
  readonly values: Action["values"];
}

/** Issues with which no setter would run an operation: errors, and a recessing blade that has to cut sideways. */
export const isRefused = ({ issues }: Plan): boolean =>
  issues.some(({ severity, code }) => severity === "error" || code === "toolCannotCutSideways");

/** The quickest job of a candidate with a tool; null where its values or its contour make no cut, or the tool breaks. */
export function fitted(
  { cycle, job, other, cut }: Pick<Candidate, "cycle" | "job" | "other" | "cut">,
  tool: Tool,
  request: PlanRequest,
): Fitted | null {
  const fit = fittedJob({ cycle, job, cut }, tool, request);
  const second = other ? fittedJob({ cycle, job: other, cut }, tool, request) : null;
  if (!fit || !second) return fit ?? second;
  return secondsOfPlan(second, request) < secondsOfPlan(fit, request) ? second : fit;
}

function fittedJob(
  { cycle, job, cut }: Pick<Candidate, "cycle" | "job" | "cut">,
  tool: Tool,
  request: PlanRequest,
): Fitted | null {
  const valued = withValues(job, cycle, tool, cut, request);
  const plan = planOf(cycle, valued.job, tool, request.shop.memory);
  if (!plan || isRefused(plan)) return null;
  const fit = fitOf(tool, plan);
  return fit.cuts ? { ...fit, ...valued, plan } : null;
}

/** Order of tools of equal reach: the usual type for the work first. */
export type Better = (a: Tool, b: Tool) => number;

/** The strongest nose first. */
const byNose = (a: Tool, b: Tool): number => noseRadius(b) - noseRadius(a) || a.T - b.T;

/** Tools that reach most first; among equals the usual type, then the strongest nose. */
export function ranked<T extends ToolFit>(fits: readonly T[], better: Better): readonly T[] {
  return fits.toSorted(
    (a, b) =>
      Number(b.makesContour) - Number(a.makesContour) ||
      better(a.tool, b.tool) ||
      Math.round(a.unreached - b.unreached) ||
      byNose(a.tool, b.tool),
  );
}

/** The best fits of tools, at most `most`: no further tool is asked once so many make the whole contour. */
function bestFits<T extends ToolFit>(
  tools: readonly Tool[],
  most: number,
  fit: (tool: Tool) => T | null,
  better: Better,
): readonly T[] {
  const fits: T[] = [];
  for (const tool of tools.toSorted((a, b) => better(a, b) || byNose(a, b))) {
    const made = fit(tool);
    if (made) fits.push(made);
    if (made?.makesContour && fits.filter(({ makesContour }) => makesContour).length >= most) break;
  }
  return ranked(fits, better).slice(0, most);
}

/** What `make` makes of the first fits that it makes something of, at most `most`. */
function firstMade<T, M>(fits: readonly T[], most: number, make: (fit: T) => M | null) {
  const all: { readonly fit: T; readonly made: M }[] = [];
  for (const fit of fits) {
    if (all.length >= most) break;
    const made = make(fit);
    if (made) all.push({ fit, made });
  }
  return all;
}

/**
 * What `make` makes of at most `most` of the operator's own tools, those first whose contour has the most elements: it
 * goes into more of the grooves. Behind them the usual tools that the table lacks, where they go deeper or none of these
 * makes its contour.
 */
export function deepest<T extends ToolFit & { readonly goesInto: number }, M>(
  fits: readonly T[],
  most: number,
  { usualTools = [] }: PlanRequest,
  make: (fit: T) => M | null,
  better: Better = () => 0,
): readonly M[] {
  const all = ranked(fits, better).toSorted((a, b) => b.goesInto - a.goesInto);
  const isUsual = ({ tool }: T) => usualTools.includes(tool.T);
  const own = firstMade(
    all.filter((fit) => !isUsual(fit)),
    most,
    make,
  );
  const reached = Math.max(0, ...own.map(({ fit: { makesContour, goesInto } }) => (makesContour ? goesInto : 0)));
  const usual = firstMade(
    all.filter((fit) => isUsual(fit) && fit.goesInto > reached),
    most,
    make,
  );
  return [...own, ...usual].map(({ made }) => made);
}

/**
 * What `fit` makes of tools, at most `most` of the best: the operator's own first, the usual ones that the table lacks only
 * where none of these makes the whole contour. Usual tools are in the order in which the trade takes them.
 */
export function fitsOf<T extends ToolFit>(
  tools: readonly Tool[],
  most: number,
  { usualTools = [] }: PlanRequest,
  fit: (tool: Tool) => T | null,
  better: Better = () => 0,
): readonly T[] {
  const isUsual = ({ T }: Tool) => usualTools.includes(T);
  const own = bestFits(
    tools.filter((tool) => !isUsual(tool)),
    most,
    fit,
    better,
  );
  if (own[0]?.makesContour) return own;
  const usual: T[] = [];
  for (const tool of tools.filter(isUsual)) {
    const made = fit(tool);
    if (made) usual.push(made);
    if (made?.makesContour && usual.filter(({ makesContour }) => makesContour).length >= most) break;
  }
  return [...own, ...ranked(usual, better).slice(0, most)];
}

/** The actions of a candidate with the tools that suit it best. */
export function actionsOf(
  candidate: Candidate,
  tools: readonly Tool[],
  most: number,
  request: PlanRequest,
  better: Better = () => 0,
): readonly Action[] {
  return fitsOf(tools, most, request, (tool) => fitted(candidate, tool, request), better).map(({ tool, job, values }) =>
    actionOf(candidate, tool, job, values),
  );
}

/** Time of the path of a job, s. */
export function secondsOfPlan(
  { job, plan: { moves } }: Pick<Fitted, "job" | "plan">,
  { shop }: Pick<PlanRequest, "shop">,
): number {
  const { mode, speed, cuttingSpeed, limit } = job.spindle;
  const spindle: Spindle =
    mode === "surface"
      ? { kind: "surface", cuttingSpeed: Number(cuttingSpeed), limit: Number(limit) }
      : { kind: "constant", speed: Number(speed) };
  let from = tipAtCall(job);
  return moves.reduce((sum, move) => {
    const seconds = secondsOf(from, move, spindle, shop.rapid);
    from = move.to;
    return sum + seconds;
  }, 0);
}

/** Time that a length of contour costs that a tool does not reach, s/mm: another tool has to take what is left there. */
const PER_UNREACHED = 1;

/**
 * The best ways among several candidates for the same place: those that reach everything, the quickest first; behind
 * those of the operator's own tools the ones of usual tools that reach more.
 */
export function bestWays(
  candidates: readonly Candidate[],
  tools: readonly Tool[],
  most: number,
  request: PlanRequest,
  better: Better = () => 0,
): readonly Action[] {
  const waysWith = (some: readonly Tool[]) =>
    candidates.flatMap((candidate) =>
      some.flatMap((tool) => {
        const fit = fitted(candidate, tool, request);
        if (!fit) return [];
        const cost = secondsOfPlan(fit, request) + PER_UNREACHED * fit.unreached;
        return [{ candidate, fit, cost: cost + (fit.makesContour ? 0 : request.rules.toolChange) }];
      }),
    );
  type Way = ReturnType<typeof waysWith>[number];
  const best = (ways: readonly Way[]) =>
    ways
      .toSorted((a, b) => better(a.fit.tool, b.fit.tool) || a.cost - b.cost || a.fit.tool.T - b.fit.tool.T)
      .slice(0, most);
  const isUsual = ({ T }: Tool) => request.usualTools?.includes(T) ?? false;
  const own = waysWith(tools.filter((tool) => !isUsual(tool)));
  const unreached = Math.min(...own.map(({ fit }) => (fit.makesContour ? 0 : fit.unreached)));
  const usual = unreached === 0 ? [] : waysWith(tools.filter(isUsual)).filter(({ fit }) => fit.unreached < unreached);
  return [...best(own), ...best(usual)].map(({ candidate, fit: { tool, job, values } }) =>
    actionOf(candidate, tool, job, values),
  );
}

/** The action of a candidate with a tool. */
export const actionOf = (
  { kind, site, cycle, box, variant }: Pick<Candidate, "kind" | "site" | "cycle" | "box" | "variant">,
  tool: Tool,
  job: SetJob,
  values: Action["values"],
): Action => ({
  kind,
  key: [
    kind,
    cycle.number,
    `T${tool.T}`,
    box.right.toFixed(2),
    box.left.toFixed(2),
    ...(variant ? [variant] : []),
  ].join(" "),
  site,
  tool,
  cycle: cycle.number,
  job,
  place: { front: box.right, rear: box.left, high: box.high, low: box.low },
  threads: [],
  values,
});

/** Actions that were not done before: the same one again cuts nothing. */
export const notDone = (actions: readonly Action[], { done }: PlanState): readonly Action[] =>
  actions.filter(({ key }) => !done.some(({ action }) => action.key === key));
