import { part, type Pt } from "../kernel/point.ts";
import type { Step } from "../kernel/step.ts";
import { pathOf } from "../kernel/time.ts";
import type { PlayPosition } from "../sim/simulation.ts";

/** Boxes round all moves, four numbers each: a pointer over a long path looks at numbers, not at arcs. */
const boxes = new WeakMap<readonly Step[], Float64Array>();

const SIDES = 4;

function boxesOf(steps: readonly Step[]): Float64Array {
  const known = boxes.get(steps);
  if (known) return known;
  const made = new Float64Array(steps.length * SIDES);
  steps.forEach(({ from, move }, i) => {
    const { left, right, low, high } = part.boxOf(pathOf(from, move));
    made.set([left, right, low, high], i * SIDES);
  });
  boxes.set(steps, made);
  return made;
}

/**
 * The move nearest to a place, within `reach` mm; of moves on the same way the one that cuts, then the last. Null where none is near.
 * `shown` says which moves are there to be pointed at.
 */
export function moveAt(steps: readonly Step[], place: Pt, reach: number, shown: (step: number) => boolean = () => true): number | null {
  const sides = boxesOf(steps);
  let best: number | null = null;
  let nearest = reach;
  let cuts = false;
  const side = (i: number, which: number) => sides[i * SIDES + which] ?? 0;
  steps.forEach((step, i) => {
    if (place.z < side(i, 0) - reach || place.z > side(i, 1) + reach) return;
    if (place.r < side(i, 2) - reach || place.r > side(i, 3) + reach || !shown(i)) return;
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

/** A moment this far along a move still belongs to it. */
const ALMOST_DONE = 0.999;

/** The moment at which the tip is nearest to a place while it makes a move. */
export function positionNear(steps: readonly Step[], step: number, place: Pt): PlayPosition {
  const made = steps[step];
  if (!made) return { step, fraction: 0 };
  const path = pathOf(made.from, made.move), long = part.lengthOf(path);
  const done = long > 0 ? part.along(path, part.nearestOn(path, place)) / long : 0;
  return { step, fraction: Math.min(ALMOST_DONE, Math.max(0, done)) };
}
