import { areaOf } from "../kernel/area/area.ts";
import { boxAround, inBox } from "../kernel/area/box.ts";
import type { Box } from "../kernel/geometry/segments.ts";
import type { Pt, Ring } from "../kernel/geometry/point.ts";
import { withoutSlivers } from "../kernel/area/real-area.ts";
import type { RearEnd } from "./work-holding.ts";
import { placeIn } from "./region.ts";
import type { SimulatedOperation } from "./simulation.ts";
import type { Sweep } from "./sweep.ts";

/** Contact tolerance at the rear plane and the outside of a blank, mm. */
const MEETS = 0.01;
/** A drill or a boring bar may run through the far end of a bore by this much, mm: a spindle is hollow. */
export const RUN_THROUGH = 5;
/** Length of the outside that must remain at the rear end to leave something to grip, mm. */
const LEAST_HELD = 1;

/**
 * The area swept behind the blank and below its diameter, where an unknown chuck grips. Inside the blank's outline a
 * tool may run through.
 */
export function sweptBehindBlank(sweep: Sweep, rear: RearEnd): Ring[] {
  const meets = sweep.pieces.some(({ box }) => box.left < rear.z - MEETS && box.low < rear.outside - MEETS);
  if (!meets) return [];
  const { left, high } = boxAround(sweep.rings);
  if (high < rear.outside - MEETS && left >= rear.z - RUN_THROUGH) return [];
  const beyond = { left: -Infinity, right: rear.z - MEETS, low: -Infinity, high: rear.outside - MEETS };
  return withoutSlivers(inBox(sweep.rings, beyond));
}

/** The last LEAST_HELD mm in front of the rear end. */
const lastOf = ({ z }: RearEnd): Box => ({ left: z, right: z + LEAST_HELD, low: 0, high: Infinity });
/** The largest radius of an area at the rear end, mm. */
const outsideAt = (area: readonly Ring[], rear: RearEnd): number => boxAround(inBox(area, lastOf(rear))).high;

/** A point at the rear end where the outside has been turned away completely; null where enough is left to grip. */
export function unheldAt(blank: readonly Ring[], stock: readonly Ring[], rear: RearEnd | null): Pt | null {
  if (!rear || areaOf(stock) === 0 || outsideAt(stock, rear) >= outsideAt(blank, rear) - MEETS) return null;
  return placeIn(inBox(stock, lastOf(rear))[0] ?? []);
}

/** The last operation whose machining area reaches the rear end; null where none does. */
export function cutsAtRear(operations: readonly SimulatedOperation[], rear: RearEnd): number | null {
  const found = operations.findLastIndex(({ plan }) => inBox([plan.area], lastOf(rear)).length > 0);
  return found < 0 ? null : found;
}
