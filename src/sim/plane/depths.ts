import { spotOn, type MillMotion } from "../../kernel/mill-motion.ts";
import { SAME } from "../../kernel/tolerance.ts";

/** More depths than an eye tells apart by their tone are put together. */
export const MOST_DEPTHS = 5;

/**
 * The depths by which a milled body is told, mm, the shallowest first: those that its program goes to between top and bottom. Of more than
 * MOST_DEPTHS some of them, evenly; each stands for what is deeper than the one before it.
 */
export function depthsOf(
  motions: readonly MillMotion[],
  { bottom, top }: { readonly bottom: number; readonly top: number },
): readonly number[] {
  const met = new Map<number, number>();
  for (const m of motions)
    for (const { z } of m.side ? [m.from, spotOn(m, 1 / 2), m.to] : [m.from, m.to])
      if (z !== null && z < top - SAME && z > bottom + SAME) met.set(Math.round(z / SAME), z);
  const all = [...met].sort(([a], [b]) => b - a).map(([, z]) => z);
  if (all.length <= MOST_DEPTHS) return all;
  return Array.from({ length: MOST_DEPTHS }, (_, i) => all[Math.ceil(((i + 1) * all.length) / MOST_DEPTHS) - 1] ?? bottom);
}

/**
 * What is told apart of a body: where it stands above each of these heights, mm. The first is its top, and what reaches up to that
 * is untouched; the last is its bottom, so that what does not stand there is milled through.
 */
export const heightLimits = (
  depths: readonly number[],
  { bottom, top }: { readonly bottom: number; readonly top: number },
): readonly number[] => [top, ...depths.slice(0, -1), bottom];
