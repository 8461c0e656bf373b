import { part, type Pt } from "../../kernel/geometry/point.ts";
import type { RoughStretch } from "../../sim/load/roughness.ts";
import type { PlayPosition } from "../../sim/simulation.ts";

/** How far a place is from a stretch, mm. */
const apartFrom = ({ points }: RoughStretch, place: Pt): number =>
  points
    .slice(1)
    .reduce(
      (least, to, i) => Math.min(least, part.distanceTo({ kind: "line", from: points[i] ?? to, to }, place)),
      Infinity,
    );

/** The stretch of a surface nearest to a place, within `reach` mm; places below the axis are mirrored. */
export function stretchNear(stretches: readonly RoughStretch[], { z, r }: Pt, reach: number): RoughStretch | null {
  const place = part.point(z, Math.abs(r));
  let [best, nearest]: [RoughStretch | null, number] = [null, reach];
  for (const each of stretches) {
    const far = apartFrom(each, place);
    if (far <= nearest) [best, nearest] = [each, far];
  }
  return best;
}

/** The stretch that is cut at a moment: of the stretches of the move, the one whose middle is nearest in time. */
export function stretchOfStep(
  stretches: readonly RoughStretch[],
  { step, fraction }: PlayPosition,
): RoughStretch | null {
  let best: RoughStretch | null = null;
  const late = (each: RoughStretch) => Math.abs(each.position.fraction - fraction);
  for (const each of stretches)
    if (each.position.step === step && (best === null || late(each) < late(best))) best = each;
  return best;
}
