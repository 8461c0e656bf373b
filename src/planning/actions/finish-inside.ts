import { boxAround } from "../../kernel/area/box.ts";
import { isUsualTool } from "../../program/tools/which-tool.ts";
import { cyclesFor } from "../../report/which/ways.ts";
import type { ActionSource } from "../types.ts";
import { insideRegions } from "./bore.ts";
import { barAction, barJobs, barsOf, freeInside, sectionOf, wayInto } from "./bore-turning.ts";

/** Thicker material is roughed first, in oversizes. */
const THIN = 2.4;
/** Operation of a cycle: finishing to size. */
const FINISH = 2;
const MOST_TOOLS = 3;

/** Finishes the inside to size, in one pass along all its elements that have material. */
export const finishInside: ActionSource = {
  kind: "finishInside",
  actions({ stock }, request) {
    const { part, rules, withoutCycles } = request;
    const left = insideRegions(stock, part);
    if (left.length === 0 || insideRegions(stock, part, THIN * (rules.allowance.diameter / 2)).length > 0) return [];
    const all = left.flatMap(({ rings }) => rings);
    const region = { rings: all, box: boxAround(all), area: left.reduce((sum, { area }) => sum + area, 0) };
    const section = sectionOf(part, region);
    const way = wayInto(stock, region);
    if (section.length === 0 || !way) return [];
    const wanted = freeInside(section);
    return cyclesFor(wanted)
      .filter((c) => c.group === "longitudinal" && !withoutCycles.includes(c.number))
      .flatMap((cycle) => {
        const tools = barsOf(request, (tool) => isUsualTool(cycle.group, tool));
        return barJobs(cycle, wanted, stock, way, { Q215: FINISH, Q483: 0, Q484: 0 }, tools)
          .toSorted((a, b) => Number(b.tool.TYPE === "FINISH") - Number(a.tool.TYPE === "FINISH"))
          .slice(0, MOST_TOOLS)
          .map((bar) => barAction("finishInside", bar, region));
      });
  },
};
