import { spotOn, type MillMotion } from "../../kernel/plane/mill-motion.ts";
import { SAME } from "../../kernel/tolerance.ts";

/** The most depths shown in different tones, and the least number of them beside shoulders. */
const MOST_DEPTHS = 5,
  LEAST_DEPTHS = 2;

/** Bottom and top of a body and its flat shoulders between them, mm. */
export interface BodyHeights {
  readonly bottom: number;
  readonly top: number;
  readonly shoulders: readonly number[];
}

/** Heights shown in different tones, mm, the highest first. */
export interface DistinctHeights {
  /** Depths that the program mills to. */
  readonly depths: readonly number[];
  /** Shoulders above the deepest of them, to distinguish a milled shoulder from a turned one. */
  readonly shoulders: readonly number[];
  /** Both in order, each once. */
  readonly heights: readonly number[];
}

/** Different heights, the highest first. */
const inOrder = (heights: readonly number[]): readonly number[] =>
  [...new Map(heights.map((z) => [Math.round(z / SAME), z]))].sort(([a], [b]) => b - a).map(([, z]) => z);

/**
 * The heights shown for a milled body: depths of its program between top and bottom. Above MOST_DEPTHS (with shoulders)
 * an even selection; each represents everything deeper than the one before it.
 */
export function distinctHeights(
  motions: readonly MillMotion[],
  { bottom, top, shoulders }: BodyHeights,
): DistinctHeights {
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
 * The limits of the areas shown: where the body reaches above each height, mm. Area up to the first (top) is
 * unmachined; area below the last (bottom) is milled through. `hasLower`: some of it is lower than all heights without
 * being milled, and is shown separately.
 */
export const heightLimits = (
  heights: readonly number[],
  { bottom, top }: Pick<BodyHeights, "bottom" | "top">,
  hasLower: boolean,
): readonly number[] => [top, ...(hasLower ? heights : heights.slice(0, -1)), bottom];
