import { cyclesFor } from "../../report/which/ways.ts";
import { isUsualTool } from "../../program/tools/which-tool.ts";
import type { OpenRegion } from "../open-regions.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { Action, ActionSource, PlanRequest } from "../types.ts";
import { insideRegions } from "./bore.ts";
import { barAction, barJobs, barsOf, between, freeInside, sectionOf, wayInto } from "./bore-turning.ts";

/** Thinner material is left to finishing, in oversizes. */
const THICK = 1.6;
/** Operation of a cycle: roughing only. */
const ROUGH = 1;
/** Most regions, and most tools for each, that are proposed. */
const [MOST_REGIONS, MOST_TOOLS] = [2, 3];

function roughing(region: OpenRegion, stock: readonly Ring[], request: PlanRequest): readonly Action[] {
  const { part, rules, withoutCycles } = request;
  const way = wayInto(stock, region);
  const section = way ? between(sectionOf(part, region), way) : [];
  if (section.length === 0 || !way) return [];
  const wanted = freeInside(section);
  const values = { Q215: ROUGH, Q483: rules.allowance.diameter, Q484: rules.allowance.z };
  return cyclesFor(wanted)
    .filter((c) => c.group === "longitudinal" && !withoutCycles.includes(c.number))
    .flatMap((cycle) => {
      const tools = barsOf(request, (t) => isUsualTool(cycle.group, t) && t.TYPE !== "FINISH");
      return barJobs(cycle, wanted, stock, way, values, tools)
        .slice(0, MOST_TOOLS)
        .map((bar) => barAction("roughInside", bar, region));
    });
}

/** Bores roughly, where the stock has a bore that a bar enters. */
export const roughInside: ActionSource = {
  kind: "roughInside",
  actions: ({ stock }, request) =>
    insideRegions(stock, request.part, THICK * (request.rules.allowance.diameter / 2))
      .slice(0, MOST_REGIONS)
      .flatMap((region) => roughing(region, stock, request)),
};
