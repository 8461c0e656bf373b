import { areaOf, difference, intersection, offset, opened } from "../kernel/clip.ts";
import { pointOn } from "../kernel/flatten.ts";
import type { Pt, Ring } from "../kernel/point.ts";
import { travelOf } from "../kernel/time.ts";
import { SLIVER } from "../kernel/tolerance.ts";
import type { Tool } from "../kernel/tool.ts";
import { axial, radius } from "../kernel/units.ts";
import { boxOf } from "./box.ts";
import { cutting } from "./cutting.ts";
import { edgesOf } from "./edges.ts";
import { machiningArea } from "./finished.ts";
import type { Outlines } from "./outlines.ts";
import { pieceOf, piecesOf } from "./piece.ts";
import { reasonFor } from "./reason.ts";
import { inside, placeIn, regionsOf, type Region } from "./region.ts";
import type { Residual, SimulatedOperation } from "./simulation.ts";
import { hullAlong, sweepAlong } from "./sweep.ts";

/** Smaller regions are not reported, mm². */
export const LEAST_RESIDUAL = 0.01;

const at = (z: number, r: number): Pt => ({ z: axial(z), r: radius(r) });
const ORIGIN = at(0, 0);

/** The middle of an area, by area. */
function middleOf(ring: Ring): Pt {
  let [z, r, twice] = [0, 0, 0];
  let a = ring[ring.length - 1] as Pt;
  for (const b of ring) {
    const w = a.z * b.r - b.z * a.r;
    [z, r, twice] = [z + (a.z + b.z) * w, r + (a.r + b.r) * w, twice + w];
    a = b;
  }
  return at(z / (3 * twice), r / (3 * twice));
}

/** Tool positions along the deepest path that are tried to find the free way. */
const TRIED = 40;

/**
 * What an insert covers when it stands anywhere between a place of the deepest path and where every position is free:
 * across the cutting direction, farther than the area is large. Across is the way that does not lead into the part.
 */
function above(insert: Ring, operation: SimulatedOperation): Ring {
  const { area, reach, part } = operation.plan;
  const places = reach.map((piece) => pointOn(piece.path, 0.5));
  const box = boxOf([...area, ...places]);
  const far = Math.max(box.right - box.left, box.top - box.bottom);
  const middle = middleOf(area);
  const side = (of: (p: Pt) => number) => {
    const weight = reach.reduce((sum, piece) => sum + travelOf(piece.path), 0) || 1;
    const mean = reach.reduce((sum, piece, i) => sum + travelOf(piece.path) * of(places[i] as Pt), 0) / weight;
    return of(middle) >= mean ? far : -far;
  };
  const body = edgesOf(offset([part], -5 * SLIVER));
  const every = Math.max(1, Math.floor(places.length / TRIED));
  const ways = [at(0, side((p) => p.r)), at(side((p) => p.z), 0)].map((way) => {
    const cover = hullAlong(insert, ORIGIN, way);
    const hits = places.filter((p, i) => i % every === 0 && body.meets(pieceOf(hullAlong(cover, p, p)))).length;
    return { cover, hits };
  });
  const [across, other] = ways as [(typeof ways)[0], (typeof ways)[0]];
  return other.hits < across.hits ? other.cover : across.cover;
}

/** What is left of an area when each operation has gone along its deepest path, with everything above that path. */
function beyondReach(left: readonly Ring[], operations: readonly SimulatedOperation[], outlines: (tool: Tool) => Outlines): Ring[] {
  const cut = cutting(left);
  for (const operation of operations) {
    const insert = outlines(toolOf(operation)).insert;
    if (insert.length < 3 || operation.plan.reach.length === 0 || operation.plan.area.length < 3) continue;
    const cover = above(insert, operation);
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
