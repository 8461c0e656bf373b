import { areaOf } from "../kernel/area/area.ts";
import { difference, intersection, isInside, opened } from "../kernel/area/clip.ts";
import type { Reason } from "../kernel/plan/issue.ts";
import type { Plan, Reach } from "../kernel/plan/plan.ts";
import { at, type Ring } from "../kernel/geometry/point.ts";
import { SLIVER } from "../kernel/tolerance.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import { boxOf } from "../kernel/area/box.ts";
import { cutting } from "./cutting.ts";
import { machiningArea } from "./finished.ts";
import { outlinesOf, type Outlines } from "./outlines.ts";
import { reasonFor } from "./reason.ts";
import { placeIn, regionsOf, type Region } from "./region.ts";
import type { Residual, SimulatedOperation } from "./simulation.ts";
import { coveredOn, hullAlong, type Sweep } from "./sweep.ts";

/** Smaller regions are not reported, mm². */
export const LEAST_RESIDUAL = 0.01;

const ORIGIN = at(0, 0);

/** Cached shapes: the outlines of tools, and the thickness of areas. */
export interface KnownShapes {
  readonly outlines: (tool: Tool) => Outlines;
  readonly thickness: (area: readonly Ring[]) => number;
}

/** Selects a path of a plan. */
type PathOf = (plan: Plan) => readonly Reach[];

/** The area left when each operation has run along a path of its plan and cleared everything above it. */
function leftBy(
  area: readonly Ring[],
  operations: readonly SimulatedOperation[],
  outlines: (tool: Tool) => Outlines,
  pathOf: PathOf,
  bare = false,
): Ring[] {
  const cut = cutting(area);
  for (const operation of operations) {
    const tool = toolOf(operation);
    const { insert } = outlines(bare ? uncorrected(tool) : tool);
    for (const swept of coverOf(operation.plan, pathOf(operation.plan), insert)) cut.add(swept);
  }
  return [...cut.stock()];
}

/** The area cleared by an insert along a path: its sweep and everything on its open side. */
function* coverOf({ area, openSide }: Plan, path: readonly Reach[], insert: Ring): Generator<Sweep> {
  if (insert.length < 3 || area.length < 3) return;
  const box = boxOf(area);
  const far = box.right - box.left + box.high - box.low;
  const cover = hullAlong(insert, ORIGIN, at(openSide.z * far, openSide.r * far));
  for (const stretch of path) yield coveredOn(cover, stretch.path);
}

/** Residual area of a region after a tool runs the deepest path of a plan made for it, mm²: compares tools. */
export function residualAreaAfter(region: Ring, plan: Plan, tool: Tool): number {
  const { insert } = outlinesOf()(plan.tool ?? tool);
  const cut = cutting([region]);
  for (const swept of coverOf(plan, plan.reach, insert)) cut.add(swept);
  return areaOf(opened(cut.stock(), SLIVER));
}

/** A tool without FUNCTION TURNDATA CORR; the same object each time, so that its outline is computed once. */
const bareTools = new WeakMap<Tool, Tool>();
function uncorrected(tool: Tool): Tool {
  if (!tool.correction) return tool;
  const known = bareTools.get(tool);
  if (known) return known;
  const { correction: _, ...bare } = tool;
  bareTools.set(tool, bare);
  return bare;
}

/** The tool as the cycle adapts it. */
const toolOf = (operation: SimulatedOperation): Tool => operation.plan.tool ?? operation.tool;

/** The last operation whose area contains a region; the last operation where none does. */
function ownerOf(region: Region, operations: readonly SimulatedOperation[]): number {
  const place = placeIn(region.outline);
  const index = operations.findLastIndex((o) => isInside(o.plan.area, place));
  return index >= 0 ? index : operations.length - 1;
}

/**
 * Residual material inside the operations' areas at the end, without slivers. Material that the deepest path of a tool
 * would clear is oversize, or, above the oversize, steps between passes. The rest is due to tool compensation, to a
 * machining limit, or to the part of the path that keeps the insert away.
 */
export function residualOf(final: readonly Ring[], all: readonly SimulatedOperation[], known: KnownShapes): Residual[] {
  // An operation without a path has already reported why; its residue would be a second finding.
  const operations = all.map((o) => (o.plan.moves.length > 0 ? o : { ...o, plan: { ...o.plan, area: [] } }));
  const area = machiningArea(operations);
  return [...withinAreas(final, area, operations, known), ...overThreads(final, area, operations, known)];
}

/** Material above the crest of a thread in no operation's area: each thread leaves it between its grooves. */
const overThreads = (
  final: readonly Ring[],
  area: readonly Ring[],
  operations: readonly SimulatedOperation[],
  known: KnownShapes,
): Residual[] =>
  operations.flatMap(({ plan }, operation) => {
    if (!plan.thread || plan.moves.length === 0) return [];
    const stands = opened(difference(intersection(final, [plan.thread.above]), area), SLIVER);
    return regionsOf(stands, LEAST_RESIDUAL).map((region) => residualAt(region, operation, "overCrest", known));
  });

const isAsked = ({ plan: { intendedResidual } }: SimulatedOperation, reason: Reason): boolean =>
  intendedResidual !== undefined &&
  ((reason === "oversize" && intendedResidual.oversize) || (reason === "insertRadius" && intendedResidual.corner));

const residualAt = (region: Region, operation: number, reason: Reason, { thickness }: KnownShapes): Residual => ({
  area: region.area,
  thickness: thickness([region.outline, ...region.holes]),
  reason,
  ring: region.outline,
  place: placeIn(region.outline),
  operation,
});

/** Residual material in the areas of the operations. */
function withinAreas(
  final: readonly Ring[],
  whole: readonly Ring[],
  operations: readonly SimulatedOperation[],
  known: KnownShapes,
): Residual[] {
  const { outlines } = known;
  const left = opened(intersection(final, whole), SLIVER);
  if (areaOf(left) <= LEAST_RESIDUAL) return [];
  const after = (area: readonly Ring[], pathOf: PathOf, bare = false) =>
    opened(leftBy(area, operations, outlines, pathOf, bare), SLIVER);
  const without = (area: readonly Ring[], rest: readonly Ring[]) =>
    rest.length === 0 ? area : opened(difference(area, rest), SLIVER);
  const reach: PathOf = (plan) => plan.reach;

  const blocked = after(left, reach);
  const free = without(left, blocked);
  const oversize = areaOf(free) > LEAST_RESIDUAL ? after(free, (plan) => plan.oversizeReach) : free;
  const corrected = operations.some((o) => toolOf(o).correction !== undefined);
  const behind = corrected && areaOf(blocked) > LEAST_RESIDUAL ? after(blocked, reach, true) : blocked;
  const limited = operations.some((o) => o.plan.unlimited);
  const kept =
    limited && areaOf(behind) > LEAST_RESIDUAL ? after(behind, (plan) => plan.unlimited ?? [], true) : behind;

  const described = (area: readonly Ring[], because: (ring: Ring, owner: SimulatedOperation) => Reason): Residual[] =>
    regionsOf(area, LEAST_RESIDUAL).map((region) => {
      const operation = ownerOf(region, operations),
        owner = operations[operation] as SimulatedOperation;
      const left = residualAt(region, operation, because(region.outline, owner), known);
      return isAsked(owner, left.reason) ? { ...left, isAsked: true } : left;
    });
  return [
    ...described(kept, (ring, owner) => reasonFor(ring, owner, outlines(toolOf(owner)))),
    ...(kept === behind ? [] : described(without(behind, kept), () => "limit")),
    ...(behind === blocked ? [] : described(without(blocked, behind), () => "correction")),
    ...(oversize === free ? [] : described(without(free, oversize), () => "smoothing")),
    ...described(oversize, () => "oversize"),
  ];
}
