import type { CornerElement } from "../kernel/corner.ts";
import type { Segment } from "../kernel/point.ts";
import type { Feed } from "../kernel/units.ts";

/** A plain path element that waits for the corner behind it. */
export interface Held {
  readonly segment: Segment;
  readonly feed: Feed | null;
  readonly index: number;
  readonly corner: { readonly element: CornerElement; readonly feed: Feed | null; readonly index: number } | null;
  /** Its number in the contour that runs on from block to block, from 1. */
  readonly element: number;
}
