import { part, type Pt } from "../../kernel/geometry/point.ts";
import type { RoughStretch } from "../../sim/load/roughness.ts";
import { classAt, classTone, type Scale } from "../load/scale.ts";
import type { StockSide } from "../material/surfaces.ts";

/** A straight piece of the surface, with its tone of the scale. */
export interface TonedSide extends StockSide {
  readonly tone: number;
}

/** Pieces that lie within this of one line are one piece, mm. */
const STRAIGHT = 0.0005;

/** Whether a piece goes straight on where another one ends. */
function goesOn({ z0, r0, z1, r1 }: StockSide, from: Pt, to: Pt): boolean {
  const [dz, dr] = [to.z - z0, to.r - r0],
    away = Math.abs((z1 - z0) * dr - (r1 - r0) * dz);
  return (
    z1 === from.z &&
    r1 === from.r &&
    away <= STRAIGHT * Math.hypot(dz, dr) &&
    (z1 - z0) * (to.z - from.z) + (r1 - r0) * (to.r - from.r) > 0
  );
}

/**
 * A flat between two flanks of a thread: it winds round the body, and before the thread is cut it would be one of many
 * rings.
 */
const isLand = (stretches: readonly RoughStretch[], i: number): boolean =>
  stretches[i - 1]?.by === "thread" && stretches[i + 1]?.by === "thread";

/** The tones of a surface, in as few straight pieces as possible; none where no value is known, and none in threads. */
export function tonedSides(stretches: readonly RoughStretch[], scale: Scale): readonly TonedSide[] {
  const sides: TonedSide[] = [];
  stretches.forEach(({ points, rz }, i) => {
    if (rz === null || isLand(stretches, i)) return;
    const tone = classTone(scale, classAt(scale, rz));
    points.slice(1).forEach((to, k) => {
      const last = sides.at(-1),
        from = points[k] ?? to;
      if (part.apart(from, to) === 0) return;
      if (last?.tone === tone && goesOn(last, from, to)) sides[sides.length - 1] = { ...last, z1: to.z, r1: to.r };
      else sides.push({ z0: from.z, r0: from.r, z1: to.z, r1: to.r, tone });
    });
  });
  return sides;
}
