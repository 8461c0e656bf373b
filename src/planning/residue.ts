import { boxAround } from "../kernel/area/box.ts";
import { difference, intersection } from "../kernel/area/clip.ts";
import { at, type Ring, type Segment } from "../kernel/geometry/point.ts";
import { SAME } from "../kernel/tolerance.ts";
import { radius, rounded, toDiameter } from "../kernel/units.ts";
import { parting } from "./actions/part-off.ts";
import { threadId, threadsOf } from "./actions/thread.ts";
import { missingFor, sideOf } from "./missing.ts";
import { areaBeyond, LEAST_GOUGE } from "./apply-action.ts";
import { LEAST_REGION, openRegions, type OpenRegion } from "./open-regions.ts";
import { actionsIn, type PlanNode, type Searching } from "./plan-node.ts";
import type { Action, PlanRequest, TriedAction } from "./types.ts";
import type { MissingTool, Residue } from "./working-plan.ts";

/** Width of a blade to part off, mm. */
const NARROW_BLADE = 2;
/** Jaws keep a tool this far away, mm. */
const BESIDE = 2;

const meets = ({ place }: Action, { box }: OpenRegion) =>
  place.rear < box.right && place.front > box.left && place.low < box.high && place.high > box.low;

/** Z of the front of jaws, chuck or collet; null without a clamping. */
function jawsOf({ clamping }: PlanRequest): number | null {
  const fronts = (clamping?.bodies ?? [])
    .filter((body) => body.part !== "tailstock")
    .map(({ rings }) => boxAround(rings).right);
  return fronts.length > 0 ? Math.max(...fronts) : null;
}

/** Whether a region lies behind the rear face. */
const isBehind = ({ box }: OpenRegion, { part }: PlanRequest) => box.right <= boxAround(part.rings).left + SAME;

/** Why a region is left where no tool is to blame; null otherwise. */
function placeReason(region: OpenRegion, request: PlanRequest): "rear" | "clamping" | null {
  const { box } = region;
  const jaws = jawsOf(request);
  // The rest of a bar is for the blade.
  if (isBehind(region, request)) return request.partsOff ? null : "rear";
  if (jaws !== null && box.right <= jaws + BESIDE) return "clamping";
  return null;
}

/** Whether something that is excluded would do what is left to do. Yields before every try. */
function* isExcluded(does: (action: Action) => boolean, end: PlanNode, s: Searching): Generator<PlanNode, boolean> {
  const { withoutCycles, withoutTools } = s.request;
  if (withoutCycles.length + withoutTools.length === 0) return false;
  const free: PlanRequest = { ...s.request, withoutCycles: [], withoutTools: [] };
  for (const action of s.sources.flatMap((source) => source.actions(end, free))) {
    if (!does(action)) continue;
    yield end;
    if (s.tries.of(action, end).works) return true;
  }
  return false;
}

/** The bore that a bar for an internal thread enters, and its length in it. */
function threadBore(segments: readonly Segment[], { blank }: PlanRequest): Partial<MissingTool> {
  const points = segments.flatMap((s) => [s.from, s.to]);
  const least = Math.min(...points.map(({ r }) => r));
  const rear = Math.min(...points.map(({ z }) => z));
  return { mostDiameter: rounded(toDiameter(radius(least))), leastReach: rounded(boxAround(blank).right - rear) };
}

/** Threads that no step makes, and why. Yields before every try. */
function* threadsLeft(end: PlanNode, s: Searching): Generator<PlanNode, readonly Residue[]> {
  const { request } = s;
  const left: Residue[] = [];
  for (const site of ["outside", "inside"] as const) {
    const chain = request.part[site];
    for (const place of threadsOf(chain)) {
      const id = threadId(chain, place);
      if (end.threads.has(id)) continue;
      const why = yield* reasonFor(
        ({ threads }) => threads.includes(id),
        () => true,
        end,
        s,
      );
      const { first, last, designation: thread } = place;
      const rows = [...new Set(chain.marks.slice(first, last + 1).map(({ row }) => row))];
      const bore = site === "inside" ? threadBore(chain.segments.slice(first, last + 1), request) : {};
      const missing: MissingTool | null = why === "tool" ? { form: "thread", site, thread, ...bore } : null;
      left.push({ region: null, thread, site, rows, why, missing });
    }
  }
  return left;
}

/**
 * Why something is left that no place protects: what does it is excluded; a tool that `takes` it without damage to the
 * part stops with a fault; or there is none. Asked before parting off, after which nothing is proposed. Yields before
 * every try.
 */
function* reasonFor(
  does: (action: Action) => boolean,
  takes: (tried: TriedAction) => boolean,
  end: PlanNode,
  s: Searching,
): Generator<PlanNode, "excluded" | "bound" | "fault" | "tool"> {
  const open = end.tried?.action.kind === "partOff" && end.before ? end.before : end;
  if (yield* isExcluded(does, open, s)) return "excluded";
  const { tries, most } = s;
  if (tries.count >= most) return "bound";
  for (const way of actionsIn(open, s).filter(does)) {
    yield open;
    const tried = tries.of(way, open);
    if (tried.faults.length > 0 && takes(tried)) return "fault";
  }
  return "tool";
}

/** Farther than any stock, mm. */
const FAR = 10_000;

/** Material outside the part in connected pieces: that beside the part, and that behind its rear face. */
function regionsLeft(stock: readonly Ring[], { part }: PlanRequest): readonly OpenRegion[] {
  const { left } = boxAround(part.rings);
  const behind: Ring = [at(-FAR, -1), at(left, -1), at(left, FAR), at(-FAR, FAR)];
  return [difference(stock, [behind]), intersection(stock, [behind])].flatMap((piece) => openRegions(piece, part));
}

/** The tool that a region needs; behind the rear face that is a blade to part off. */
function missingOf(region: OpenRegion, { stock }: PlanNode, request: PlanRequest): MissingTool {
  if (!isBehind(region, request)) return missingFor(region, request);
  const { depth } = parting(stock, boxAround(request.part.rings).left, NARROW_BLADE);
  return { form: "recessing", site: "outside", leastDepth: rounded(depth) };
}

/**
 * What the end of a search leaves, with the reason and the tool that is missing. `stock`: what its whole program leaves.
 */
export function* residueOf(
  end: PlanNode,
  stock: readonly Ring[],
  s: Searching,
): Generator<PlanNode, readonly Residue[]> {
  const { request } = s;
  const left: Residue[] = [];
  for (const region of regionsLeft(stock, request)) {
    const { site, border } = sideOf(region, request.part);
    const chain = site === "inside" ? request.part.inside : request.part.outside;
    const rows = [...new Set(border.flatMap((i) => chain.marks[i]?.row ?? []))];
    const takes = ({ stock: rest, gouge }: TriedAction) =>
      gouge < LEAST_GOUGE && areaBeyond(region.rings, rest) > LEAST_REGION;
    const why = placeReason(region, request) ?? (yield* reasonFor((action) => meets(action, region), takes, end, s));
    left.push({
      region,
      thread: null,
      site,
      rows,
      why,
      missing: why === "tool" || why === "fault" ? missingOf(region, end, request) : null,
    });
  }
  return [...left, ...(yield* threadsLeft(end, s))];
}
