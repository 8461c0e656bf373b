import { boxAround } from "../kernel/area/box.ts";
import { difference, intersection } from "../kernel/area/clip.ts";
import { at, type Ring } from "../kernel/geometry/point.ts";
import { SAME } from "../kernel/tolerance.ts";
import { missingFor, sideOf } from "./missing.ts";
import { openRegions, type OpenRegion } from "./open-regions.ts";
import { actionsIn, type PlanNode, type Searching } from "./plan-node.ts";
import type { Action, ElementMark, PlanRequest } from "./types.ts";
import type { Residue } from "./working-plan.ts";

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

/** Why a region is left where no tool is to blame; null otherwise. */
function placeReason({ box }: OpenRegion, request: PlanRequest): "rear" | "clamping" | null {
  const jaws = jawsOf(request);
  const { left } = boxAround(request.part.rings);
  if (box.right <= left + SAME) return "rear";
  if (jaws !== null && box.right <= jaws + BESIDE) return "clamping";
  return null;
}

/** Whether something that is excluded would take some of a region. Yields before every try. */
function* isExcluded(region: OpenRegion, end: PlanNode, s: Searching): Generator<PlanNode, boolean> {
  const { withoutCycles, withoutTools } = s.request;
  if (withoutCycles.length + withoutTools.length === 0) return false;
  const free: PlanRequest = { ...s.request, withoutCycles: [], withoutTools: [] };
  for (const action of s.sources.flatMap((source) => source.actions(end, free))) {
    if (!meets(action, region)) continue;
    yield end;
    if (s.tries.of(action, end).works) return true;
  }
  return false;
}

/** Designations of the threads of a part, each once for each cylinder or cone. */
const threadsOf = ({ part: { outside, inside } }: PlanRequest) =>
  ([outside, inside] as const).flatMap(({ marks }, i) =>
    marks.flatMap((mark: ElementMark, at) =>
      mark.thread !== undefined && marks[at - 1]?.row !== mark.row
        ? [{ thread: mark.thread, row: mark.row, site: i === 0 ? ("outside" as const) : ("inside" as const) }]
        : [],
    ),
  );

/** Threads that no step makes. */
function threadsLeft({ done }: PlanNode, request: PlanRequest): readonly Residue[] {
  const made = done.flatMap(({ action }) => action.threads);
  const wanted = threadsOf(request);
  return wanted
    .filter(({ thread }, i) => {
      const same = wanted.slice(0, i).filter((w) => w.thread === thread).length;
      return made.filter((m) => m.includes(thread)).length <= same;
    })
    .map(({ thread, row, site }) => ({
      region: null,
      site,
      rows: [row],
      why: "tool",
      missing: { form: "thread", site, thread },
    }));
}

/** Why a region is left that no place and no choice protects. */
function triedReason(isOpen: boolean, { tries, most }: Searching): "bound" | "fault" | "tool" {
  if (tries.count >= most) return "bound";
  return isOpen ? "fault" : "tool";
}

/** Farther than any stock, mm. */
const FAR = 10_000;

/** Material outside the part in connected pieces: that beside the part, and that behind its rear face. */
function regionsLeft(stock: readonly Ring[], { part }: PlanRequest): readonly OpenRegion[] {
  const { left } = boxAround(part.rings);
  const behind: Ring = [at(-FAR, -1), at(left, -1), at(left, FAR), at(-FAR, FAR)];
  return [difference(stock, [behind]), intersection(stock, [behind])].flatMap((piece) => openRegions(piece, part));
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
  const failed = actionsIn(end, s);
  const left: Residue[] = [];
  for (const region of regionsLeft(stock, request)) {
    const { site, border } = sideOf(region, request.part);
    const chain = site === "inside" ? request.part.inside : request.part.outside;
    const rows = [...new Set(border.flatMap((i) => chain.marks[i]?.row ?? []))];
    const isOpen = failed.some((a) => meets(a, region));
    const why =
      placeReason(region, request) ?? ((yield* isExcluded(region, end, s)) ? "excluded" : triedReason(isOpen, s));
    left.push({
      region,
      site,
      rows,
      why,
      missing: why === "tool" || why === "fault" ? missingFor(region, request) : null,
    });
  }
  return [...left, ...threadsLeft(end, request)];
}
