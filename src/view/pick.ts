import { part, type Pt } from "../kernel/point.ts";
import type { Step } from "../kernel/step.ts";
import { pathOf } from "../kernel/time.ts";

/** The move nearest to a place, within `reach` mm; of moves on the same way the one that cuts, then the last. Null where none is near. */
export function moveAt(steps: readonly Step[], place: Pt, reach: number): number | null {
  let best: number | null = null;
  let nearest = reach;
  let cuts = false;
  steps.forEach((step, i) => {
    const d = part.distanceTo(pathOf(step.from, step.move), place), cutting = step.move.kind !== "rapid";
    if (d > reach) return;
    if (best === null || (cutting && !cuts) || (cutting === cuts && d <= nearest)) {
      best = i;
      nearest = d;
      cuts = cutting;
    }
  });
  return best;
}
