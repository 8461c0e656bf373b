import { areaOf } from "../kernel/area/area.ts";
import { boxAround, inBox } from "../kernel/area/box.ts";
import type { Box } from "../kernel/geometry/segments.ts";
import type { Pt, Ring } from "../kernel/geometry/point.ts";
import { real } from "../kernel/area/real-area.ts";
import type { RearEnd } from "./held.ts";
import { placeIn } from "./region.ts";
import type { SimulatedOperation } from "./simulation.ts";
import type { Sweep } from "./sweep.ts";

/** The rear plane and the outside of a blank are met by less than this, mm. */
const MEETS = 0.01;
/** A drill or a boring bar may run through the far end of a bore by this much, mm: a spindle is hollow. */
const RUN_THROUGH = 5;
/** This much of the outside has to stay at the rear end for something to be left to hold, mm. */
const LEAST_HELD = 1;

/**
 * What a sweep covers behind the blank and below its diameter. What holds the work stands there, and nobody knows
 * where; inside the blank's outline a tool may run through.
 */
export function behind(sweep: Sweep, rear: RearEnd): Ring[] {
  const meets = sweep.pieces.some(({ box }) => box.left < rear.z - MEETS && box.low < rear.outside - MEETS);
  if (!meets) return [];
  const { left, high } = boxAround(sweep.rings);
  if (high < rear.outside - MEETS && left >= rear.z - RUN_THROUGH) return [];
  const beyond = { left: -Infinity, right: rear.z - MEETS, low: -Infinity, high: rear.outside - MEETS };
  return real(inBox(sweep.rings, beyond));
}

/** The last piece in front of the rear end. */
const lastOf = ({ z }: RearEnd): Box => ({ left: z, right: z + LEAST_HELD, low: 0, high: Infinity });
/** The largest radius of an area there, mm. */
const outsideAt = (area: readonly Ring[], rear: RearEnd): number => boxAround(inBox(area, lastOf(rear))).high;

/**
 * Where the outside of a blank is turned away to the very end at which it is held, a point there; null: something is
 * left to hold.
 */
export function unheldAt(blank: readonly Ring[], stock: readonly Ring[], rear: RearEnd | null): Pt | null {
  if (!rear || areaOf(stock) === 0 || outsideAt(stock, rear) >= outsideAt(blank, rear) - MEETS) return null;
  return placeIn(inBox(stock, lastOf(rear))[0] ?? []);
}

/** The last operation that is to cut at the rear end; null where none is. */
export function cutsAtRear(operations: readonly SimulatedOperation[], rear: RearEnd): number | null {
  const found = operations.findLastIndex(({ plan }) => inBox([plan.area], lastOf(rear)).length > 0);
  return found < 0 ? null : found;
}
