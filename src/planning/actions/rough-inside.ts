import type { Ring } from "../../kernel/geometry/point.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { radiusOf } from "../../kernel/units.ts";
import { isUsualTool } from "../../program/tools/which-tool.ts";
import { cyclesFor } from "../../report/which/ways.ts";
import type { OpenRegion } from "../open-regions.ts";
import type { Action, ActionSource, PlanRequest, PlanState } from "../types.ts";
import { thickRegions } from "./bore.ts";
import { barActions, barsOf, wholeFirst } from "./bars.ts";
import { freeInside, plungings, ROUGH_BEYOND, sectionInBore } from "./bore-turning.ts";
import { finestOf, isToleranced } from "./finest.ts";
import { notDone } from "./candidates.ts";
import { withoutEdge } from "./front.ts";

/** Thinner material is left to finishing, in oversizes. */
export const THICK = 1.6;
/** Most regions, and most tools for each, that are proposed. */
const [MOST_REGIONS, MOST_TOOLS] = [2, 2];

const isSlim = ({ TYPE }: Tool) => TYPE === "FINISH";

function roughing(region: OpenRegion, stock: readonly Ring[], request: PlanRequest): readonly Action[] {
  const oversize = radiusOf(request.rules.allowance.diameter);
  const section = sectionInBore(stock, request.part, region, { oversize, more: ROUGH_BEYOND });
  if (!section) return [];
  const { segments, way, isDeep } = section;
  const wanted = freeInside(segments);
  const plain = withoutEdge(segments, "inside");
  // The cone that a drill has left on a flat bottom is faced from the axis on.
  const hasFloor = (segments.at(-1)?.to.r ?? 1) < SAME;
  const cut = { operation: "rough", work: "rough" } as const;
  const ways = cyclesFor(wanted)
    .filter(({ group }) => group === "longitudinal" || (group === "transverse" && hasFloor))
    .filter(({ number }) => !request.withoutCycles.includes(number))
    .flatMap((cycle) => {
      const tools = barsOf(request, (t) => isUsualTool(cycle.group, t));
      const [strong, slim] = [tools.filter((t) => !isSlim(t)), tools.filter(isSlim)];
      return plungings(segments).flatMap((plunges) => {
        const into = {
          ...(plunges !== undefined && { plunges }),
          ...(plain && cycle.group === "longitudinal" && { other: freeInside(plain) }),
        };
        const work = { kind: "roughInside", wanted, region, way, cut, most: MOST_TOOLS, ...into } as const;
        return [
          barActions(work, cycle, strong, stock, request),
          // What the strong inserts cannot reach behind a neck.
          ...(isDeep && plunges !== false ? [barActions({ ...work, most: 1 }, cycle, slim, stock, request)] : []),
        ];
      });
    });
  return wholeFirst(ways);
}

function turning(region: OpenRegion, stock: readonly Ring[], request: PlanRequest): readonly Action[] {
  const section = sectionInBore(stock, request.part, region);
  if (!section || isToleranced(section)) return [];
  const { segments, way } = section;
  const wanted = freeInside(segments);
  const roughness = finestOf(section);
  const cut = { operation: "both", work: "rough", ...(roughness !== undefined && { roughness }) } as const;
  return cyclesFor(wanted)
    .filter(({ group, number }) => group === "longitudinal" && !request.withoutCycles.includes(number))
    .flatMap((cycle) => {
      const tools = barsOf(request, (t) => isUsualTool(cycle.group, t));
      const plunges = plungings(segments).includes(true);
      const into = plunges ? { plunges } : {};
      return barActions(
        { kind: "roughInside", wanted, region, way, cut, most: MOST_TOOLS, ...into },
        cycle,
        tools,
        stock,
        request,
      ).whole;
    });
}

const roughRegions = ({ stock }: PlanState, request: PlanRequest): readonly OpenRegion[] =>
  thickRegions(stock, request, THICK * radiusOf(request.rules.allowance.diameter));

/** The actions on the largest regions that a bar can cut. */
function onLargest(
  regions: readonly OpenRegion[],
  actionsOn: (region: OpenRegion) => readonly Action[],
): readonly Action[] {
  const made: (readonly Action[])[] = [];
  for (const region of regions) {
    if (made.length >= MOST_REGIONS) break;
    const actions = actionsOn(region);
    if (actions.length > 0) made.push(actions);
  }
  return made.flat();
}

/** Bores roughly, where the stock has a bore that a bar enters. */
export const roughInside: ActionSource = {
  kind: "roughInside",
  actions: (state, request) =>
    notDone(
      onLargest(roughRegions(state, request), (region) => roughing(region, state.stock, request)),
      state,
    ),
};

/** The same to its finished size in one call, where nothing of it is toleranced. */
export const turnInside: ActionSource = {
  kind: "roughInside",
  inOneCall: true,
  actions: (state, request) =>
    notDone(
      onLargest(roughRegions(state, request), (region) => turning(region, state.stock, request)),
      state,
    ),
};
