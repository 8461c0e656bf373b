import { boxAround } from "../../kernel/area/box.ts";
import { part as geometry } from "../../kernel/geometry/point.ts";
import type { Ring, Segment } from "../../kernel/geometry/point.ts";
import { CHORD, SAME } from "../../kernel/tolerance.ts";
import { worksAcross } from "../../cycles/use.ts";
import { frontOf } from "../../program/job/stock-surface.ts";
import { isUsualTool } from "../../program/tools/which-tool.ts";
import { cyclesFor } from "../../report/which/ways.ts";
import type { OpenRegion } from "../open-regions.ts";
import type { Action, ActionSource, PlannedPart, PlanRequest } from "../types.ts";
import { boredTo, clearRadius, insideRegions } from "./bore.ts";
import { barActions, barsOf, crossing, freeInside, sectionOf, type BoreWay, type Section } from "./bore-turning.ts";
import { notDone } from "./candidates.ts";
import { THICK } from "./rough-inside.ts";

/** Clearance of the start point below the wall of the bore, mm. */
const BESIDE = 0.5;
/** The bore beside a groove is measured so far within it, mm. */
const WITHIN = 0.3;
/** Shallower sections are no grooves, mm. */
const SHALLOWEST = 0.1;
/** Most grooves, and most tools for each, that are proposed. */
const [MOST_GROOVES, MOST_TOOLS] = [2, 2];

/** A section whose walls end at its mouth; null where it is not wider than the bore at both of its ends. */
function sunk(segments: readonly Segment[]): readonly Segment[] | null {
  const { high } = boxAround([geometry.flattenedChain(segments, CHORD)]);
  const [first, last] = [segments[0], segments.at(-1)];
  if (!first || !last || segments.length < 2) return null;
  const mouth = Math.max(first.from.r, last.to.r);
  if (mouth > high - SHALLOWEST) return null;
  const cut = (s: Segment) => geometry.pointOn(s, crossing(s, mouth, "r"));
  const begin = first.from.r < mouth - SAME ? { ...first, from: cut(first) } : first;
  const end = last.to.r < mouth - SAME ? { ...last, to: cut(last) } : last;
  return [begin, ...segments.slice(1, -1), end];
}

/** The section of a groove in a bore with the marks of its elements; null for other regions. */
export function grooveOf(part: PlannedPart, region: OpenRegion): Section | null {
  const { segments, marks } = sectionOf(part, region);
  const groove = sunk(segments);
  return groove && { segments: groove, marks };
}

function recessing(region: OpenRegion, stock: readonly Ring[], request: PlanRequest): readonly Action[] {
  const { box } = region;
  const { segments = [], marks = [] } = grooveOf(request.part, region) ?? {};
  const first = segments[0]?.from;
  if (!first || boredTo(stock) > box.left) return [];
  const clear = clearRadius(stock, box.left + WITHIN, frontOf(stock));
  const way: BoreWay = { z: first.z, clear, low: clear - BESIDE };
  const wanted = freeInside(segments);
  const fine = marks.flatMap(({ roughness }) => roughness ?? []);
  const cut = {
    operation: "both",
    work: "recess",
    depth: box.high - clear,
    ...(fine.length > 0 && { roughness: Math.min(...fine) }),
  } as const;
  const work = { kind: "recess", wanted, region, way, cut, most: MOST_TOOLS } as const;
  return cyclesFor(wanted)
    .filter((c) => c.group === "recessing" || c.group === "recessTurning")
    .filter((c) => !worksAcross(c) && !request.withoutCycles.includes(c.number))
    .flatMap((cycle) => {
      const tools = barsOf(request, (tool) => isUsualTool(cycle.group, tool));
      return barActions(work, cycle, tools, stock, request);
    });
}

/** Grooves and undercuts in a bore. */
export const recessInside: ActionSource = {
  kind: "recess",
  actions: (state, request) => {
    const thick = THICK * (request.rules.allowance.diameter / 2);
    const rough = insideRegions(state.stock, request.part, thick);
    const regions = rough.length > 0 ? rough : insideRegions(state.stock, request.part);
    const grooves = regions.flatMap((region) => recessing(region, state.stock, request));
    return notDone(grooves.slice(0, MOST_GROOVES * MOST_TOOLS), state);
  },
};
