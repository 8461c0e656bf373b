import { areaOf, difference, intersection, opened } from "../kernel/clip.ts";
import type { Pt, Ring } from "../kernel/point.ts";
import { SLIVER } from "../kernel/tolerance.ts";
import type { Tool } from "../kernel/tool.ts";
import { axial, radius } from "../kernel/units.ts";
import { boxOf } from "./box.ts";
import { cutting } from "./cutting.ts";
import { machiningArea } from "./finished.ts";

import type { Outlines } from "./outlines.ts";
import { piecesOf } from "./piece.ts";
import { reasonFor } from "./reason.ts";
import { inside, placeIn, regionsOf, type Region } from "./region.ts";
import type { Residual, SimulatedOperation } from "./simulation.ts";
import { hullAlong, sweepAlong } from "./sweep.ts";

/** Smaller regions are not reported, mm². */
export const LEAST_RESIDUAL = 0.01;

const at = (z: number, r: number): Pt => ({ z: axial(z), r: radius(r) });
const ORIGIN = at(0, 0);

/** What is left of an area when each operation has gone along its deepest path, with everything above that path. */
function beyondReach(left: readonly Ring[], operations: readonly SimulatedOperation[], outlines: (tool: Tool) => Outlines): Ring[] {
  const cut = cutting(left);
  for (const operation of operations) {
    const insert = outlines(toolOf(operation)).insert;
    if (insert.length < 3 || operation.plan.reach.length === 0 || operation.plan.area.length < 3) continue;
    const { area, openSide } = operation.plan;
    const box = boxOf(area);
    const far = box.right - box.left + box.top - box.bottom;
    const cover = hullAlong(insert, ORIGIN, at(openSide.z * far, openSide.r * far));
    for (const piece of operation.plan.reach) cut.add(piecesOf(sweepAlong(cover, piece.path)));
  }
  return [...cut.stock()];
}

/** The tool as the cycle adapts it. */
const toolOf = (operation: SimulatedOperation): Tool => operation.plan.tool ?? operation.tool;

/** The last operation whose area holds a region; the last of all when it lies between areas. */
function ownerOf(region: Region, operations: readonly SimulatedOperation[]): number {
  const place = placeIn(region.outline);
  const index = operations.findLastIndex((o) => inside(o.plan.area, place));
  return index >= 0 ? index : operations.length - 1;
}

/**
 * Material inside the areas of the operations that is still there at the end, thin slivers apart. What the deepest path
 * of a tool would take is oversize; the rest is explained by the stretch of that path that keeps the insert away.
 */
export function residualOf(
  final: readonly Ring[], operations: readonly SimulatedOperation[], outlines: (tool: Tool) => Outlines,
): Residual[] {
  const left = opened(intersection(final, machiningArea(operations)), SLIVER);
  if (areaOf(left) <= LEAST_RESIDUAL) return [];
  const blocked = opened(beyondReach(left, operations, outlines), SLIVER);
  const free = opened(difference(left, blocked), SLIVER);
  const described = (region: Region, because: (operation: number) => Residual["reason"]): Residual => {
    const operation = ownerOf(region, operations);
    return { area: region.area, reason: because(operation), ring: region.outline, place: placeIn(region.outline), operation };
  };
  const why = (ring: Ring) => (operation: number) => {
    const owner = operations[operation] as SimulatedOperation;
    return reasonFor(ring, owner, outlines(toolOf(owner)));
  };
  return [
    ...regionsOf(blocked, LEAST_RESIDUAL).map((region) => described(region, why(region.outline))),
    ...regionsOf(free, LEAST_RESIDUAL).map((region) => described(region, () => "oversize")),
  ];
}
