import { boxAround } from "../../kernel/area/box.ts";
import { difference, offset, opened } from "../../kernel/area/clip.ts";
import { part as geometry } from "../../kernel/geometry/point.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { CHORD, SAME, SLIVER } from "../../kernel/tolerance.ts";
import { radiusOf } from "../../kernel/units.ts";
import { isUsualTool } from "../../program/tools/which-tool.ts";
import { cyclesFor } from "../../report/which/ways.ts";
import { regionsOf } from "../../sim/region.ts";
import { LEAST_REGION } from "../open-regions.ts";
import type { ActionSource } from "../types.ts";
import { insideRegions, thickRegions } from "./bore.ts";
import { barActions, barsOf, wholeFirst } from "./bars.ts";
import { freeInside, plungings, sectionInBore } from "./bore-turning.ts";
import { notDone } from "./candidates.ts";
import { finestOf } from "./finest.ts";
import { reamedSkin } from "./ream.ts";

/** Thicker material is roughed first, in oversizes. */
const THIN = 2.4;
const MOST_TOOLS = 2;

const finishersFirst = (a: Tool, b: Tool) => Number(b.TYPE === "FINISH") - Number(a.TYPE === "FINISH");

/** Finishes the inside to size, in one pass along all its elements that have material. */
export const finishInside: ActionSource = {
  kind: "finishInside",
  actions(state, request) {
    const { part, rules, withoutCycles } = request;
    const { stock } = state;
    const least = THIN * radiusOf(rules.allowance.diameter);
    const thick = thickRegions(stock, request, least);
    // What is thicker is for a groove's own tool, for roughing, or for the second clamping.
    const heavy = offset(
      thick.flatMap(({ rings }) => rings),
      least,
    );
    const thin = difference(
      insideRegions(stock, part).flatMap(({ rings }) => rings),
      heavy,
    );
    const left = regionsOf(opened(difference(thin, reamedSkin(stock, request)), SLIVER), LEAST_REGION);
    if (left.length === 0) return [];
    const all = left.flatMap(({ outline, holes }) => [outline, ...holes]);
    const region = { rings: all, box: boxAround(all), area: left.reduce((sum, { area }) => sum + area, 0) };
    const section = sectionInBore(stock, part, region);
    const last = section?.segments.at(-1);
    if (!section || !last) return [];
    const { segments: whole, way } = section;
    // A thick bar leaves a bottom that a thinner one faces from the axis on.
    const isFloor = last.to.r < SAME && last.from.z - last.to.z < SAME;
    const variants = [
      { segments: whole, groups: isFloor ? ["longitudinal", "transverse"] : ["longitudinal"] },
      ...(isFloor && whole.length > 1 ? [{ segments: whole.slice(0, -1), groups: ["longitudinal"] }] : []),
    ];
    const roughness = finestOf(section);
    const cut = { operation: "finish", work: "finish", ...(roughness !== undefined && { roughness }) } as const;
    const ways = variants.flatMap(({ segments, groups }) => {
      const wanted = freeInside(segments);
      const box = boxAround([geometry.flattenedChain(segments, CHORD)]);
      return cyclesFor(wanted)
        .filter((c) => groups.includes(c.group) && !withoutCycles.includes(c.number))
        .flatMap((cycle) => {
          const tools = barsOf(request, (tool) => isUsualTool(cycle.group, tool));
          return plungings(segments).flatMap((plunges) => {
            if (plunges === true && thick.length > 0) return [];
            const into = plunges === undefined ? {} : { plunges };
            const work = {
              kind: "finishInside",
              wanted,
              region: { box, rings: all },
              way,
              cut,
              most: MOST_TOOLS,
              ...into,
            } as const;
            return [barActions(work, cycle, tools, stock, request, finishersFirst)];
          });
        });
    });
    return notDone(wholeFirst(ways), state);
  },
};
