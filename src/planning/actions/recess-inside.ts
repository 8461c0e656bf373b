import { boxAround } from "../../kernel/area/box.ts";
import { at, part as geometry, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import { worksAcross } from "../../cycles/use.ts";
import { radiusOf } from "../../kernel/units.ts";
import { frontOf } from "../../program/job/stock-surface.ts";
import { isUsualTool } from "../../program/tools/which-tool.ts";
import { cyclesFor } from "../../report/which/ways.ts";
import { borderOf, type OpenRegion } from "../open-regions.ts";
import type { Action, ActionSource, Chain, PlannedPart, PlanRequest } from "../types.ts";
import { boredTo, clearRadius, insideRegions } from "./bore.ts";
import { barActions, barsOf } from "./bars.ts";
import { freeInside, type BoreWay, type Section } from "./bore-turning.ts";
import { notDone } from "./candidates.ts";
import { finestOf } from "./finest.ts";
import { pocketsOf, type Pocket } from "./pockets.ts";
import { THICK } from "./rough-inside.ts";

/** Clearance of the start point below the wall of the bore, mm. */
const BESIDE = 0.5;
/** The bore beside a groove is measured so far within it, mm. */
const WITHIN = 0.3;
/** Most regions, and most tools for each, that are proposed. */
const [MOST_REGIONS, MOST_TOOLS] = [3, 2];

/** The same element on the other side of the axis: what is deep in a bore is low there. */
const mirrored = (s: Segment): Segment => {
  const over = ({ z, r }: Pt) => at(z, -r);
  const ends = { from: over(s.from), to: over(s.to) };
  return s.kind === "line"
    ? { ...s, ...ends }
    : { ...s, ...ends, centre: over(s.centre), turn: s.turn === "cw" ? "ccw" : "cw" };
};

/** The grooves of a bore are the same for every stock. */
const known = new WeakMap<Chain, readonly Pocket[]>();

function groovesOf(inside: Chain): readonly Pocket[] {
  const before = known.get(inside);
  if (before) return before;
  const found = pocketsOf({ ...inside, segments: inside.segments.map(mirrored) }, "r");
  const grooves = found.map((groove) => ({ ...groove, segments: groove.segments.map(mirrored) }));
  known.set(inside, grooves);
  return grooves;
}

/** The groove in a bore that a region lies in, with walls up to its mouth; null for other regions. */
export function grooveOf({ inside }: PlannedPart, region: OpenRegion): Section | null {
  const border = borderOf(inside, region);
  if (!border) return null;
  return groovesOf(inside).find(({ first, last }) => border[0] >= first && border[1] <= last) ?? null;
}

function recessing(region: OpenRegion, stock: readonly Ring[], request: PlanRequest): readonly Action[] {
  const { segments = [], marks = [] } = grooveOf(request.part, region) ?? {};
  const first = segments[0]?.from;
  const box = boxAround([geometry.flattenedChain(segments, CHORD)]);
  if (!first || boredTo(stock) > box.left) return [];
  const clear = clearRadius(stock, box.left + WITHIN, frontOf(stock));
  const way: BoreWay = { z: first.z, clear, low: clear - BESIDE };
  const wanted = freeInside(segments);
  const roughness = finestOf({ marks });
  const cut = {
    operation: "both",
    work: "recess",
    depth: box.high - clear,
    ...(roughness !== undefined && { roughness }),
  } as const;
  const work = { kind: "recess", wanted, region: { box, rings: region.rings }, way, cut, most: MOST_TOOLS } as const;
  return cyclesFor(wanted)
    .filter((c) => c.group === "recessing" || c.group === "recessTurning")
    .filter((c) => !worksAcross(c) && !request.withoutCycles.includes(c.number))
    .flatMap((cycle) => {
      const tools = barsOf(request, (tool) => isUsualTool(cycle.group, tool));
      return barActions(work, cycle, tools, stock, request).whole;
    });
}

/** Grooves and undercuts in a bore: of those with more than finishing takes, else of all with something left in them. */
export const recessInside: ActionSource = {
  kind: "recess",
  actions: (state, request) => {
    const thick = THICK * radiusOf(request.rules.allowance.diameter);
    const inGroove = (region: OpenRegion) => grooveOf(request.part, region) !== null;
    const rough = insideRegions(state.stock, request.part, thick).filter(inGroove);
    const regions = rough.length > 0 ? rough : insideRegions(state.stock, request.part).filter(inGroove);
    const grooves = regions.slice(0, MOST_REGIONS).flatMap((region) => recessing(region, state.stock, request));
    const distinct = grooves.filter(({ key }, i) => grooves.findIndex((other) => other.key === key) === i);
    return notDone(distinct, state);
  },
};
