import { boxAround } from "../../kernel/area/box.ts";
import { part as geometry } from "../../kernel/geometry/point.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import { worksAcross } from "../../cycles/use.ts";
import { frontOf } from "../../program/job/stock-surface.ts";
import { isUsualTool } from "../../program/tools/which-tool.ts";
import { cyclesFor } from "../../report/which/ways.ts";
import type { OpenRegion } from "../open-regions.ts";
import type { Action, ActionSource, PlanRequest } from "../types.ts";
import { boredTo, clearRadius, insideRegions } from "./bore.ts";
import { barActions, barsOf, freeInside, sectionOf, type BoreWay } from "./bore-turning.ts";
import { notDone } from "./candidates.ts";
import { THICK } from "./rough-inside.ts";

/** Clearance of the start point below the wall of the bore, mm. */
const BESIDE = 0.5;
/** Shallower sections are no grooves, mm. */
const SHALLOWEST = 0.1;
/** Most grooves, and most tools for each, that are proposed. */
const [MOST_GROOVES, MOST_TOOLS] = [2, 2];

/** Whether a section is wider than the bore at both of its ends. */
function isSunk(segments: ReturnType<typeof sectionOf>["segments"]): boolean {
  const { high } = boxAround([geometry.flattenedChain(segments, CHORD)]);
  const ends = [segments[0]?.from.r, segments.at(-1)?.to.r];
  return ends.every((r) => r !== undefined && r < high - SHALLOWEST);
}

function recessing(region: OpenRegion, stock: readonly Ring[], request: PlanRequest): readonly Action[] {
  const { segments, marks } = sectionOf(request.part, region);
  const { box } = region;
  const first = segments[0]?.from;
  if (!first || !isSunk(segments) || boredTo(stock) > box.left) return [];
  const clear = clearRadius(stock, box.left, frontOf(stock));
  const way: BoreWay = { z: first.z, clear, low: clear - BESIDE, front: Infinity, rear: -Infinity };
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
