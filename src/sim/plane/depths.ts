import { spotOn, type MillMotion } from "../../kernel/mill-motion.ts";
import { SAME } from "../../kernel/tolerance.ts";

/** More depths than an eye tells apart by their tone are put together. */
const MOST_DEPTHS = 5;

/** Between which heights a body stands, mm, and whether it reaches up to its top everywhere. */
export interface BodyHeights {
  readonly bottom: number;
  readonly top: number;
  readonly isStepped: boolean;
}

/**
 * The depths by which a milled body is told, mm, the shallowest first: those that its program goes to between top and bottom. Of more than
 * MOST_DEPTHS some of them, evenly; each stands for what is deeper than the one before it. Of a stepped body one fewer: what is lower than
 * all of them without being milled is told apart as well.
 */
export function depthsOf(motions: readonly MillMotion[], { bottom, top, isStepped }: BodyHeights): readonly number[] {
  const met = new Map<number, number>();
  for (const m of motions)
    for (const { z } of m.side ? [m.from, spotOn(m, 1 / 2), m.to] : [m.from, m.to])
      if (z !== null && z < top - SAME && z > bottom + SAME) met.set(Math.round(z / SAME), z);
  const all = [...met].sort(([a], [b]) => b - a).map(([, z]) => z);
  const most = isStepped ? MOST_DEPTHS - 1 : MOST_DEPTHS;
  return all.length <= most ? all : Array.from({ length: most }, (_, i) => all[Math.ceil(((i + 1) * all.length) / most) - 1] ?? bottom);
}

/**
 * What is told apart of a body: where it stands above each of these heights, mm. The first is its top, and what reaches up to that
 * is untouched; the last is its bottom, so that what does not stand there is milled through.
 */
export const heightLimits = (
  depths: readonly number[],
  { bottom, top, isStepped }: BodyHeights,
): readonly number[] => [top, ...(isStepped ? depths : depths.slice(0, -1)), bottom];
