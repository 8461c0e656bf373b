import { areaOf } from "../../src/kernel/area/area.ts";
import { tipDirection } from "../../src/kernel/cutter/insert.ts";
import { diameter, radiusOf } from "../../src/kernel/units.ts";
import { outlinesOf } from "../../src/sim/outlines.ts";
import { boxAround, inBox } from "../../src/kernel/area/box.ts";
import { difference, opened, union } from "../../src/kernel/area/clip.ts";
import { at, part as space, type Ring } from "../../src/kernel/geometry/point.ts";
import { boredTo, clearRadius } from "../../src/planning/actions/bore.ts";
import { ncLabels } from "../../src/i18n/nc-labels.ts";
import { SLIVER } from "../../src/kernel/tolerance.ts";
import { regionsOf } from "../../src/sim/region.ts";
import { actionSources } from "../../src/planning/actions/index.ts";
import { areaBeyond } from "../../src/planning/apply-action.ts";
import { LEAST_REGION, type OpenRegion } from "../../src/planning/open-regions.ts";
import type { FinishedPart } from "../../src/planning/part/finished-part.ts";
import { plannedPart } from "../../src/planning/part/planned-part.ts";
import { planning } from "../../src/planning/plan.ts";
import { actionsIn, Ends, firstNode, nodeBehind, type PlanNode, type Searching } from "../../src/planning/plan-node.ts";
import { SEQUENCES } from "../../src/planning/sequences.ts";
import { USUAL_RULES } from "../../src/planning/shop-rules.ts";
import { Trade } from "../../src/planning/trade-rules.ts";
import { Tries } from "../../src/planning/tries.ts";
import type { Action, ActionKind, PlannedPart, PlanRequest } from "../../src/planning/types.ts";
import type { PlanChanges, WorkingPlan } from "../../src/planning/working-plan.ts";
import { builtInTools } from "../../src/program/iso-codes/usual-tools.ts";
import { touched, turningTools } from "./reach-bound.ts";

/** What a part is planned from; null where the part is none. */
export function requestOf(file: FinishedPart): PlanRequest | null {
  const { part, blank, clamping } = plannedPart(file);
  return (
    part && {
      part,
      blank,
      clamping,
      shop: { ...builtInTools.table, rapid: 10_000 },
      usualTools: builtInTools.usual,
      material: file.material,
      rules: { ...USUAL_RULES, ...file.rules },
      partsOff: file.partsOff,
      withoutCycles: [],
      withoutTools: [],
      labels: ncLabels("en"),
    }
  );
}

/** The same with the operator's own tools only, without the usual ones that the table lacks. */
export function withOwnTools(request: PlanRequest): PlanRequest {
  const { shop, usualTools = [] } = request;
  return { ...request, shop: { ...shop, tools: shop.tools.filter(({ T }) => !usualTools.includes(T)) } };
}

/** A search to its end. */
export function planOf(request: PlanRequest, changes: PlanChanges = {}, sources = actionSources): WorkingPlan {
  const search = planning(request, changes, sources);
  for (;;) {
    const next = search.next();
    if (next.done) return next.value;
  }
}

export const keysOf = ({ steps }: WorkingPlan): readonly string[] => steps.map(({ tried }) => tried.action.key);

export const searching = (request: PlanRequest): Searching => ({
  request,
  sources: actionSources,
  tries: new Tries(request),
  trade: new Trade(request),
  hand: new Map(),
  most: Infinity,
  known: new Map(),
  ends: new Ends(),
  without: new Set(),
});

/** The plan of a sequence: of each kind the first way that works, as often as one does. */
export function fixedSequence(kinds: readonly ActionKind[], request: PlanRequest, s: Searching): PlanNode {
  let node = firstNode(s);
  for (const kind of kinds)
    for (;;) {
      const from: PlanNode = node;
      const works = actionsIn(from, s, kind)
        .filter((a) => a.kind === kind && (kind !== "partOff" || request.partsOff))
        .map((a) => s.tries.of(a, from))
        .find((t) => t.works);
      if (!works) break;
      node = nodeBehind(from, works, s);
    }
  return node;
}

/** The end of a plan as a node of a search. */
export function endOf({ steps }: WorkingPlan, s: Searching): PlanNode {
  let node = firstNode(s);
  for (const { tried } of steps) node = nodeBehind(node, tried, s);
  return node;
}

/** Work of a bar in a bore. */
const IN_BORE = new Set(["roughInside", "finishInside", "recess"]);

/** Undercuts behind threads. */
const isRelief = (undercut = "") => undercut.startsWith("DIN 76");

/**
 * Steps of a plan that were not prepared: a thread before its relief, a bar before the bore that it goes into, a holder
 * that touches something. Empty where all were.
 */
export function unprepared({ steps, setup: { part, blank }, judged }: WorkingPlan): readonly string[] {
  const stockBefore = (i: number) => steps[i - 1]?.tried.stock ?? blank;
  const isReady = ({ kind, site, place }: Action, stock: readonly Ring[]): boolean => {
    const { segments, marks } = site === "inside" ? part.inside : part.outside;
    if (site === "inside" && IN_BORE.has(kind)) return boredTo(stock) < place.front;
    if (kind !== "thread") return true;
    return segments.every((segment, i) => {
      const { left, right, low, high } = space.boxOf(segment);
      const there = inBox(stock, { left, right, low: low - 1, high: high + 1 });
      return !isRelief(marks[i]?.undercut) || areaBeyond(there, part.rings) < LEAST_REGION;
    });
  };
  return [
    ...steps.flatMap(({ tried: { action } }, i) =>
      isReady(action, stockBefore(i)) ? [] : [`not prepared: ${action.key}`],
    ),
    ...judged.reasons.flatMap(({ kind }) => (kind === "holderContact" ? ["a holder touches"] : [])),
  ];
}

/** Steps of Z at which a bore is measured, and thickness of what is not reached, mm. */
const [DEPTHS, UNREACHED] = [0.1, 0.05];
/** Farther than any part, mm. */
const FAR = 10_000;

/**
 * Tools that stand in a bore at a region, and do not only touch its mouth from in front of the face, with what of it lies
 * as deep as each goes: to its least bore, or without one as far as its whole body fits across the bore.
 */
export function barsAt({ box, rings: area }: OpenRegion, { part: { rings }, shop }: PlanRequest) {
  const front = boxAround(rings).right;
  const depth = Array.from({ length: Math.ceil((front - box.left) / DEPTHS) + 1 }, (_, i) => front - i * DEPTHS);
  return turningTools(shop.tools).flatMap((tool) => {
    if (tipDirection(tool.TO).v <= 0) return [];
    const { insert, holder } = outlinesOf()(tool);
    const least = radiusOf(tool.DMIN ?? diameter(-boxAround([insert, ...holder]).low));
    const rear = depth.find((z) => clearRadius(rings, z - DEPTHS, front) < least) ?? -Infinity;
    const goes = Math.max(rear, front - boxAround(holder).right);
    return [{ tool, area: inBox(area, { left: goes, right: FAR, low: -1, high: FAR }) }];
  });
}

/**
 * What is reached of a region in a bore along elements that are reached up to their wall from end to end: a bar that takes
 * less makes no element.
 */
export function wholeElements(
  reached: readonly Ring[],
  { rings }: OpenRegion,
  { inside: { segments } }: PlannedPart,
): readonly Ring[] {
  const bands = regionsOf(opened(difference(rings, reached), UNREACHED), 0).map(({ outline }) => {
    const { left, right } = boxAround([outline]);
    const along = segments.filter(({ from, to }) => to.z < right - DEPTHS && from.z > left + DEPTHS);
    const [rear, front] = [
      Math.min(left, ...along.map(({ to }) => to.z)),
      Math.max(right, ...along.map((s) => s.from.z)),
    ];
    return [at(rear, -1), at(front, -1), at(front, FAR), at(rear, FAR)];
  });
  return opened(difference(reached, bands), SLIVER);
}

/** Regions that a plan leaves as if a tool were missing, though those of the table reach work in them by their shape. */
export function leftThoughReached(request: PlanRequest, plan = planOf(request)): readonly string[] {
  const { stock } = endOf(plan, searching(request));
  const { left } = boxAround(request.part.rings);
  const behind = inBox(stock, { left: -Infinity, right: left, low: 0, high: Infinity });
  const stays = [...request.part.rings, ...behind];
  return plan.residue.flatMap(({ region, why, site }) => {
    if (!region || why !== "tool") return [];
    const tools =
      site === "inside"
        ? barsAt(region, request)
        : turningTools(request.shop.tools).map((tool) => ({ tool, area: region.rings }));
    const all = tools.flatMap(({ tool, area }) => {
      const rings = area.length > 0 ? touched(area, stays, tool) : [];
      return rings.length > 0 ? [{ tool, rings }] : [];
    });
    const reached = union(all.flatMap(({ rings }) => rings));
    const area = areaOf(site === "inside" ? wholeElements(reached, region, request.part) : reached);
    if (area < LEAST_REGION) return [];
    const names = all.map(({ tool }) => `T${tool.T}`).join(", ");
    return [`${site} ${region.area.toFixed(2)} mm² left, ${area.toFixed(2)} reached by the shape of ${names}`];
  });
}

/** s. */
const SAME_COST = 0.01;

/**
 * Other ends that make no less than one and leave less, or take less time: by their own count, not by that of the search.
 * All that leave no more than a region above the least of them leave as much.
 */
function betterThan(end: PlanNode, others: readonly PlanNode[]): readonly PlanNode[] {
  const able = others.filter(({ threads }) => threads.size >= end.threads.size);
  const least = Math.min(end.left, ...able.map(({ left }) => left)) + LEAST_REGION;
  return able.filter(({ left, cost }) => left < least && (end.left >= least || cost < end.cost - SAME_COST));
}

/** What a plan breaks of what every plan keeps; empty where it breaks nothing. */
export function brokenByPart(request: PlanRequest, plan = planOf(request)): readonly string[] {
  const s = searching(request);
  const end = endOf(plan, s);
  const fixed = betterThan(
    end,
    SEQUENCES.map((kinds) => fixedSequence(kinds, request, s)),
  );
  const open = actionsIn(end, s).filter((a) => {
    const tried = s.tries.of(a, end);
    const { left, threads } = nodeBehind(end, tried, s);
    return tried.works && (left < end.left - LEAST_REGION || threads.size > end.threads.size);
  });
  const again = planOf(request);
  const kept = planOf(request, { keep: keysOf(plan) });
  return [
    ...(plan.steps.length > 0 && plan.judged.verdict !== "proved"
      ? [`not proved: ${JSON.stringify(plan.judged.reasons[0])}`]
      : []),
    ...(plan.gouge > 0.01 ? [`gouge ${plan.gouge}`] : []),
    ...unprepared(plan),
    ...open.map(({ key }) => `left for ${key}`),
    ...fixed.map(
      ({ cost, left }) =>
        `worse than a fixed sequence: ${end.cost} s and ${end.left} mm² left, ${cost} s and ${left} mm²`,
    ),
    ...(again.text === plan.text ? [] : ["another plan of the same request"]),
    ...(kept.text === plan.text ? [] : ["another plan when nothing changed"]),
    ...(kept.tries <= plan.tries ? [] : ["more tries when nothing changed"]),
  ];
}
