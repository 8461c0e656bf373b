import { part, type Segment } from "../../kernel/point.ts";
import type { LoadLine } from "../load/lines.ts";
import type { StockSide } from "../material/surfaces.ts";

/** A straight piece of the surface with the tone of the scale that tells something of it. */
export interface TonedSide extends StockSide {
  readonly tone: number;
}

/** Pieces that lie within this of one line are one piece, mm. */
const STRAIGHT = 0.0005;

/** Whether a piece goes straight on where another one ends. */
function goesOn({ z0, r0, z1, r1 }: StockSide, { from, to }: Segment): boolean {
  const [dz, dr] = [to.z - z0, to.r - r0], away = Math.abs((z1 - z0) * dr - (r1 - r0) * dz);
  return z1 === from.z && r1 === from.r && away <= STRAIGHT * Math.hypot(dz, dr)
    && (z1 - z0) * (to.z - from.z) + (r1 - r0) * (to.r - from.r) > 0;
}

/** What is told by tones along a surface, in as few straight pieces as it has; where no number is told there are none. */
export function tonedSides(lines: readonly Pick<LoadLine, "tone" | "segments">[]): readonly TonedSide[] {
  const sides: TonedSide[] = [];
  for (const { tone, segments } of lines) {
    if (tone === null) continue;
    for (const segment of segments) {
      const last = sides.at(-1), { from, to } = segment;
      if (part.apart(from, to) === 0) continue;
      if (last?.tone === tone && goesOn(last, segment)) sides[sides.length - 1] = { ...last, z1: to.z, r1: to.r };
      else sides.push({ z0: from.z, r0: from.r, z1: to.z, r1: to.r, tone });
    }
  }
  return sides;
}
