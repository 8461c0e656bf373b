import type { Cycle, Group } from "../../cycles/define.ts";
import { worksAcross } from "../../cycles/use.ts";
import type { ShapeRequest } from "../../cycles/shape-request.ts";
import type { Plan } from "../../kernel/plan/plan.ts";
import { part, type Segment } from "../../kernel/geometry/point.ts";
import { CHORD, SAME } from "../../kernel/tolerance.ts";
import { toDiameter, radius } from "../../kernel/units.ts";
import { tipOffset } from "../../kernel/cutter/insert.ts";
import type { SetJob } from "../../program/job/job.ts";
import { withCycleValues } from "../../program/job/requested-job.ts";
import { boxAroundContour } from "../../program/job/requested-shape.ts";
import { fitOf, type ToolFit } from "../../program/tools/which-tool.ts";
import { cyclesFor } from "../../report/which/ways.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { Action, Chain, PlanRequest } from "../types.ts";
import { actionOf, deepest, fitted, isRefused, type Better, type Candidate, type Fitted } from "./candidates.ts";
import { contourJob, planOf } from "./contour-job.ts";
import { perObject, perText } from "../../nc/per-object.ts";
import type { OutsideWork, Piece } from "./outside-work.ts";
import { withoutFront } from "./front.ts";
import { bridgedOver, fromTheFront, isValley, type Pocket } from "./pockets.ts";
import { OPERATION, workOf, type CutRequest } from "./values-of-job.ts";

/** Turning cycles for a section of the contour that are not excluded. `allowance`: of stock along the contour, mm. */
export function turningCycles(
  segments: readonly Segment[],
  { withoutCycles }: PlanRequest,
  allowance = 0,
): readonly Cycle[] {
  const wanted = {
    site: "outside",
    shape: "free",
    angle: 0,
    pitch: 1,
    contour: segments,
    allowance: allowance as ShapeRequest["allowance"],
    ...boxAroundContour(segments, "outside"),
  } as const;
  return cyclesFor(wanted).filter(
    (c) => (c.group === "longitudinal" || c.group === "transverse") && !withoutCycles.includes(c.number),
  );
}

/** Share of a pocket's wall that a tool may miss and still be sent into it. */
const MOST_MISSED = 0.5;
const BY_TOOL: ReadonlySet<string | null> = new Set(["mainEdge", "secondaryEdge", "toolWidth", "cutLength"]);

/** Length of the path over a pocket that the shape of a tool keeps off its contour, as a share of its mouth. */
function missed({ reach }: Plan, { segments, axis }: Pocket): number {
  const along = axis === "r" ? "z" : "r";
  const ends = [segments[0]?.from[along] ?? 0, segments.at(-1)?.to[along] ?? 0];
  const [low, high] = [Math.min(...ends), Math.max(...ends)];
  const over = ({ path: { from, to } }: Plan["reach"][number]) =>
    Math.max(0, Math.min(high, Math.max(from[along], to[along])) - Math.max(low, Math.min(from[along], to[along])));
  const width = Math.max(SAME, high - low);
  return reach.reduce((sum, part) => sum + (BY_TOOL.has(part.reason) ? over(part) : 0), 0) / width;
}

/** Area between the mouth of a pocket and a path that is `shift` mm behind its points, mm². */
function areaUnder({ segments, level, axis }: Pocket, path: readonly Segment[], shift = 0): number {
  const along = axis === "r" ? "z" : "r";
  const ends = [segments[0]?.from[along] ?? 0, segments.at(-1)?.to[along] ?? 0];
  const within = (at: number) => Math.min(Math.max(...ends), Math.max(Math.min(...ends), at + shift));
  const points = part.flattenedChain(path, CHORD);
  return points.slice(1).reduce((sum, to, i) => {
    const from = points[i] ?? to;
    return sum + Math.abs(within(to[along]) - within(from[along])) * Math.max(0, level - (from[axis] + to[axis]) / 2);
  }, 0);
}

/** Share of a hollow of a face that the nose of a tool has to reach for the tool to be sent into it. */
const LEAST_REACHED = 0.6;

/** Whether a tool reaches enough of a hollow of a face to be sent into it: a narrow groove is left to blades. */
function reaches({ reach }: Plan, tool: Tool, hollow: Pocket): boolean {
  const shift = -tipOffset(tool).v;
  const reached = reach.reduce((sum, { path }) => sum + areaUnder(hollow, [path], shift), 0);
  return reached > LEAST_REACHED * areaUnder(hollow, hollow.segments);
}

/** Whether a pocket is no work of a turning tool, whatever its reach: a groove is left to blades. */
const isForBlades = (pocket: Pocket): boolean => pocket.axis === "r" && !isValley(pocket);

/** Whether a tool is sent into a pocket. */
const suits = (plan: Plan, tool: Tool, pocket: Pocket): boolean =>
  pocket.axis === "z" ? reaches(plan, tool, pocket) : !isForBlades(pocket) && missed(plan, pocket) <= MOST_MISSED;

/** The pockets that a tool is not sent into: it would not reach most of them. */
const unsuited = (plan: Plan, tool: Tool, pockets: readonly Pocket[]): readonly Pocket[] =>
  pockets.flatMap((pocket) => (suits(plan, tool, pocket) ? unsuited(plan, tool, pocket.inner) : [pocket]));

const bridgedChains = perObject((_: Chain) => perText<Chain>());

/** The chain of a work over some of its pockets, the same object for each stock. */
export function bridgedIn({ chain }: OutsideWork, pockets: readonly Pocket[], isAcross: boolean): Chain {
  const places = pockets
    .toSorted(fromTheFront)
    .map(({ axis, first, last, level }) => [axis, first, last, level].join(" "));
  const bridged = bridgedChains(chain)(places.join(), () => bridgedOver(chain, pockets));
  return isAcross ? bridged : withoutFront(bridged);
}

/** A tool with the path that it can follow along a contour. */
interface Reach extends ToolFit {
  readonly plan: Plan;
}

/** Finishing passes along sections that go into every hollow, by the cycle. */
const passesOf = perObject((_: readonly Segment[]) => perText<SetJob>());

/**
 * How far a tool follows a contour with a cycle: that is the same in each stock and with all cutting values, so that it is
 * asked for in front of the blank. Null where it makes no cut.
 */
function reachAlong(cycle: Cycle, { segments }: Chain, tool: Tool, request: PlanRequest): Reach | null {
  const job = passesOf(segments)(String(cycle.number), () =>
    withCycleValues(contourJob(cycle, { segments, way: "ahead", stock: request.blank }), [
      ["Q215", OPERATION.finish],
      ["Q487", 1],
    ]),
  );
  const plan = planOf(cycle, job, tool, request.shop.memory);
  if (!plan || isRefused(plan)) return null;
  const fit = fitOf(tool, plan);
  return fit.cuts ? { ...fit, plan } : null;
}

/**
 * The chain as a tool turns it: without grooves across its way, those with nothing left in them, and those that it does
 * not reach. A cycle along the axis goes into the cylinders, one across it into the faces.
 */
function turnedChain(work: OutsideWork, cycle: Cycle, tool: Tool, request: PlanRequest): Chain {
  const { pockets, pieces } = work;
  const isAcross = worksAcross(cycle);
  const own = pockets.filter(({ axis }) => (axis === "z") === isAcross);
  const done = own.filter(({ first, last }) => !pieces.some(({ borders: [a, b] }) => a < last && b > first));
  const closed = [...pockets.filter((pocket) => !own.includes(pocket)), ...done];
  const open = own.filter((pocket) => !done.includes(pocket));
  if (open.every(isForBlades)) return bridgedIn(work, [...closed, ...open], isAcross);
  const plain = bridgedIn(work, closed, isAcross);
  const reach = reachAlong(cycle, plain, tool, request);
  const skipped = reach ? unsuited(reach.plan, tool, open) : open;
  return skipped.length === 0 ? plain : bridgedIn(work, [...closed, ...skipped], isAcross);
}

/** A way to turn the chain of a work with a cycle. */
export interface TurnedWay {
  readonly candidate: Omit<Candidate, "job" | "other">;
  readonly tools: readonly Tool[];
  /** Most tools. */
  readonly most: number;
  readonly better?: Better;
  /** What of the chain as a tool turns it is cut; no element: nothing. */
  readonly cutChain: (chain: Chain) => Chain;
  readonly jobsOf: (chain: Chain) => Pick<Candidate, "job" | "other">;
  readonly isWanted?: (fit: Fitted) => boolean;
}

/** The actions of a way with the tools that go into most of the grooves. */
export function turnings(
  work: OutsideWork,
  { candidate, tools, most, better, cutChain, jobsOf, isWanted = () => true }: TurnedWay,
  request: PlanRequest,
): readonly Action[] {
  const { cycle, cut } = candidate;
  const fits = tools.flatMap((tool) => {
    const chain = cutChain(turnedChain(work, cycle, tool, request));
    const reach = chain.segments.length > 0 ? reachAlong(cycle, chain, tool, request) : null;
    return reach ? { ...reach, chain, goesInto: chain.segments.length } : [];
  });
  const made = ({ tool, chain }: (typeof fits)[number]) => {
    const fit = fitted({ cycle, cut, ...jobsOf(chain) }, tool, request);
    return fit && isWanted(fit) ? actionOf(candidate, tool, fit.job, fit.values) : null;
  };
  return deepest(fits, most, request, made, better);
}

/** What the values of a cut of a section depend on. */
export const cutOf = (
  group: Group,
  operation: CutRequest["operation"],
  { box, stock, roughness }: Pick<Piece, "box"> & Pick<CutRequest, "stock" | "roughness">,
): CutRequest => ({
  operation,
  work: workOf(group, operation),
  smallest: toDiameter(radius(box.low)),
  largest: toDiameter(radius(box.high)),
  stock,
  ...(roughness !== undefined && { roughness }),
});

/** Tools of these types first, in this order. */
export const typesFirst =
  (...types: readonly Tool["TYPE"][]) =>
  (a: Tool, b: Tool): number => {
    const place = ({ TYPE }: Tool) => (types.includes(TYPE) ? types.indexOf(TYPE) : types.length);
    return place(a) - place(b);
  };
