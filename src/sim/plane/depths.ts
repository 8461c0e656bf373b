import { spotOn, type MillMotion } from "../../kernel/plane/mill-motion.ts";
import { SAME } from "../../kernel/tolerance.ts";

/** More depths than an eye tells apart by their tone are put together, but for this many at least. */
const MOST_DEPTHS = 5,
  LEAST_DEPTHS = 2;

/** Between which heights a body stands, and the heights of its flat shoulders between them, mm. */
export interface BodyHeights {
  readonly bottom: number;
  readonly top: number;
  readonly shoulders: readonly number[];
}

/** Heights that are told apart, mm, the highest first. */
export interface ToldHeights {
  /** Those that the program goes to. */
  readonly depths: readonly number[];
  /** Shoulders over the deepest of them: what is milled there is told from what only stands lower. */
  readonly shoulders: readonly number[];
  /** Both in order, each once. */
  readonly heights: readonly number[];
}

/** Different heights, the highest first. */
const inOrder = (heights: readonly number[]): readonly number[] =>
  [...new Map(heights.map((z) => [Math.round(z / SAME), z]))].sort(([a], [b]) => b - a).map(([, z]) => z);

/**
 * The heights by which a milled body is told: those that its program goes to between top and bottom. Of more than
 * MOST_DEPTHS, shoulders counted, some of them, evenly; each stands for what is deeper than the one before it.
 */
export function toldHeights(motions: readonly MillMotion[], { bottom, top, shoulders }: BodyHeights): ToldHeights {
  const all = inOrder(
    motions.flatMap((m) =>
      (m.side ? [m.from, spotOn(m, 1 / 2), m.to] : [m.from, m.to]).flatMap(({ z }) =>
        z !== null && z < top - SAME && z > bottom + SAME ? [z] : [],
      ),
    ),
  );
  const deepest = all.at(-1) ?? top,
    over = inOrder(shoulders.filter((z) => z > deepest + SAME));
  const most = Math.max(LEAST_DEPTHS, MOST_DEPTHS - over.length);
  const depths =
    all.length <= most
      ? all
      : Array.from({ length: most }, (_, i) => all[Math.ceil(((i + 1) * all.length) / most) - 1] ?? bottom);
  return { depths, shoulders: over, heights: inOrder([...over, ...depths]) };
}

/**
 * What is told apart of a body: where it stands above each of these heights, mm. The first is its top, and what reaches
 * up to that is untouched; the last is its bottom, so that what does not stand there is milled through. `hasLower`:
 * some of it is lower than all heights without being milled, and is told apart as well.
 */
export const heightLimits = (
  heights: readonly number[],
  { bottom, top }: Pick<BodyHeights, "bottom" | "top">,
  hasLower: boolean,
): readonly number[] => [top, ...(hasLower ? heights : heights.slice(0, -1)), bottom];
