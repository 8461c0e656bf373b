import type { Place, Size } from "../camera.ts";
import { arrange, type Item, type Spot } from "../dimensions/arrange.ts";
import type { LabelBox } from "../dimensions/labels.ts";

/** Height of a name, and its distances from the place that it names, pixels. */
const TALL = 16,
  ASIDE = [10, 30, 54] as const;
/** Space that the scales take at the left and the lower edge, pixels. */
const EDGES = { left: 46, below: 22 } as const;

/**
 * The box of a name beside a place: right or left of it, above or below, where it lies in the picture and covers none
 * of the kept boxes; without such a place where it covers least of them.
 */
export function namePlace({ x, y }: Place, width: number, size: Size, kept: readonly LabelBox[]): LabelBox {
  const boxes = ASIDE.flatMap((off) =>
    [-off - TALL, off].flatMap((down) =>
      [off, -off - width].map((right): LabelBox => ({ x: x + right, y: y + down, width, height: TALL })),
    ),
  );
  const room = { x: EDGES.left, y: 0, width: size.width - EDGES.left, height: size.height - EDGES.below };
  const item: Item<Spot> = {
    q: "",
    candidates: boxes.map((label, cost) => ({ label, lines: [], cost })),
    needed: true,
    moved: (spot, label) => ({ ...spot, label }),
  };
  return arrange([item], { ...size, room, avoid: [], kept })[0]?.label ?? { x, y, width, height: TALL };
}
