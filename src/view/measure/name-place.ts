import type { Place, Size } from "../camera.ts";
import { labelsOverlap, type LabelBox } from "../dimensions/labels.ts";

/** Height of a name, and its distances from the place that it names, pixels. */
const TALL = 16,
  ASIDE = [10, 30, 54] as const;
/** Space that the scales take at the left and the lower edge, pixels. */
const EDGES = { left: 46, below: 22 } as const;

/**
 * The box of a name beside a place: right or left of it, above or below, where it lies in the picture and covers none
 * of the kept boxes; without such a place above it on the right.
 */
export function namePlace({ x, y }: Place, width: number, size: Size, kept: readonly LabelBox[]): LabelBox {
  const boxes = ASIDE.flatMap((off) =>
    [-off - TALL, off].flatMap((down) =>
      [off, -off - width].map((right): LabelBox => ({ x: x + right, y: y + down, width, height: TALL })),
    ),
  );
  const isFree = (box: LabelBox) =>
    box.x >= EDGES.left &&
    box.y >= 0 &&
    box.x + width <= size.width &&
    box.y + TALL <= size.height - EDGES.below &&
    !kept.some((other) => labelsOverlap(other, box));
  return boxes.find(isFree) ?? { x: x + ASIDE[0], y: y - ASIDE[0] - TALL, width, height: TALL };
}
