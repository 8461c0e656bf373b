import { below, type Envelope, type Interval } from "../envelope.ts";
import { SAME } from "../tolerance.ts";

/** The clearance of recess turning, mm: the manual calls its programmed set-up clearance reserved, so it is fixed. */
export const RECESS_CLEARANCE = 2;

/** A u in the middle of the first valley at a level. */
export function deepestIn(e: Envelope, height: number, span: Interval): number {
  const v = below(e, height, span.from, span.to)[0];
  return v ? (v.from + v.to) / 2 : (span.from + span.to) / 2;
}

/** The valley at a level that holds `u`; a point when there is none. */
export function containing(e: Envelope, height: number, span: Interval, u: number): Interval {
  return below(e, height, span.from, span.to).find((v) => v.from <= u + SAME && v.to >= u - SAME) ?? { from: u, to: u };
}
