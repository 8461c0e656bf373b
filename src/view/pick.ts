import { flattened } from "../kernel/flatten.ts";
import type { Pt } from "../kernel/point.ts";
import type { Step } from "../kernel/step.ts";
import { CHORD } from "../kernel/tolerance.ts";

/** Distance of a place from the straight line between two points, mm. */
function distance(p: Pt, a: Pt, b: Pt): number {
  const [dz, dr] = [b.z - a.z, b.r - a.r];
  const size = dz * dz + dr * dr;
  const along = size === 0 ? 0 : Math.min(1, Math.max(0, ((p.z - a.z) * dz + (p.r - a.r) * dr) / size));
  return Math.hypot(p.z - a.z - along * dz, p.r - a.r - along * dr);
}

function distanceToStep(p: Pt, { from, move }: Step): number {
  if (move.kind !== "arc") return distance(p, from, move.to);
  const points = flattened({ kind: "arc", from, to: move.to, centre: move.centre, turn: move.turn }, CHORD * 20);
  let nearest = Infinity;
  for (let i = 1; i < points.length; i += 1) {
    const [a, b] = [points[i - 1], points[i]];
    if (a && b) nearest = Math.min(nearest, distance(p, a, b));
  }
  return nearest;
}

/** The move nearest to a place, within `reach` mm; of moves on the same way the one that cuts, then the last. Null where none is near. */
export function moveAt(steps: readonly Step[], place: Pt, reach: number): number | null {
  let best: number | null = null;
  let nearest = reach;
  let cuts = false;
  steps.forEach((step, i) => {
    const d = distanceToStep(place, step), cutting = step.move.kind !== "rapid";
    if (d > reach) return;
    if (best === null || (cutting && !cuts) || (cutting === cuts && d <= nearest)) {
      best = i;
      nearest = d;
      cuts = cutting;
    }
  });
  return best;
}
