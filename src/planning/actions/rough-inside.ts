import type { Ring } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { isUsualTool } from "../../program/tools/which-tool.ts";
import { cyclesFor } from "../../report/which/ways.ts";
import type { OpenRegion } from "../open-regions.ts";
import type { Action, ActionSource, PlanRequest } from "../types.ts";
import { insideRegions } from "./bore.ts";
import { barActions, barsOf, between, freeInside, sectionOf, wayInto } from "./bore-turning.ts";
import { notDone } from "./candidates.ts";

/** Thinner material is left to finishing, in oversizes. */
export const THICK = 1.6;
/** Most regions, and most tools for each, that are proposed. */
const [MOST_REGIONS, MOST_TOOLS] = [2, 3];

function roughing(region: OpenRegion, stock: readonly Ring[], request: PlanRequest): readonly Action[] {
  const way = wayInto(stock, region);
  const segments = way ? between(sectionOf(request.part, region).segments, way) : [];
  if (segments.length === 0 || !way) return [];
  const wanted = freeInside(segments);
  // The cone that a drill has left on a flat bottom is faced from the axis on.
  const hasFloor = (segments.at(-1)?.to.r ?? 1) < SAME;
  const cut = { operation: "rough", work: "rough" } as const;
  const work = { kind: "roughInside", wanted, region, way, cut, most: MOST_TOOLS } as const;
  return cyclesFor(wanted)
    .filter(({ group }) => group === "longitudinal" || (group === "transverse" && hasFloor))
    .filter(({ number }) => !request.withoutCycles.includes(number))
    .flatMap((cycle) => {
      const tools = barsOf(request, (t) => isUsualTool(cycle.group, t) && t.TYPE !== "FINISH");
      return barActions(work, cycle, tools, stock, request);
    });
}

/** Bores roughly, where the stock has a bore that a bar enters. */
export const roughInside: ActionSource = {
  kind: "roughInside",
  actions: (state, request) =>
    notDone(
      insideRegions(state.stock, request.part, THICK * (request.rules.allowance.diameter / 2))
        .slice(0, MOST_REGIONS)
        .flatMap((region) => roughing(region, state.stock, request)),
      state,
    ),
};
