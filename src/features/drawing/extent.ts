import { part, type Segment } from "../../kernel/geometry/point.ts";
import type { Bounds, Margin } from "../../view/camera.ts";

/** Free units of the page round the drawing, for labels and marks at its edge. */
export const SHEET_MARGIN: Margin = { left: 36, right: 36, top: 32, bottom: 32 };

const NOTHING: Bounds = { left: -10, right: 10, low: -10, high: 10 };

/** The smallest box round lines and arcs; an empty one has a default size. */
export function boundsOfSegments(segments: readonly Segment[]): Bounds {
  let all: Bounds | null = null;
  for (const s of segments) {
    const box = part.boxOf(s);
    all = all
      ? {
          left: Math.min(all.left, box.left),
          right: Math.max(all.right, box.right),
          low: Math.min(all.low, box.low),
          high: Math.max(all.high, box.high),
        }
      : box;
  }
  return all ?? NOTHING;
}

export const extent = ({ left, right, low, high }: Bounds) => ({ wide: right - left, tall: high - low });

/** A box with a margin on each side, as a share of its size or, for a mere point, in mm. */
export function widened(box: Bounds, by: number): Bounds {
  const { wide, tall } = extent(box),
    own = Math.max(wide, tall),
    more = own > 0 ? own * by : by;
  return { left: box.left - more, right: box.right + more, low: box.low - more, high: box.high + more };
}
