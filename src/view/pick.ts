import { part, type Pt, type Segment } from "../kernel/geometry/point.ts";
import type { Step } from "../kernel/time/step.ts";
import { pathOf } from "../kernel/time/time.ts";
import type { PlayPosition } from "../sim/simulation.ts";

/** Access to the steps of a path: the way of each, and whether it cuts. */
export interface StepAccess<S> {
  readonly wayOf: (step: S) => Segment;
  readonly cuts: (step: S) => boolean;
}

/** Boxes round all moves, four numbers each, so that a hit test on a long path compares numbers instead of arcs. */
const boxes = new WeakMap<readonly unknown[], Float64Array>();

const SIDES = 4;

function boxesOf<S>(steps: readonly S[], { wayOf }: StepAccess<S>): Float64Array {
  const known = boxes.get(steps);
  if (known) return known;
  const made = new Float64Array(steps.length * SIDES);
  steps.forEach((step, i) => {
    const { left, right, low, high } = part.boxOf(wayOf(step));
    made.set([left, right, low, high], i * SIDES);
  });
  boxes.set(steps, made);
  return made;
}

/**
 * The step nearest to a place, within `reach` mm; of steps on the same way the one that cuts, then the last. Null if
 * none is near. `shown` tells which steps can be picked.
 */
export function nearestStep<S>(
  steps: readonly S[],
  looked: StepAccess<S>,
  place: Pt,
  reach: number,
  shown: (step: number) => boolean = () => true,
): number | null {
  const sides = boxesOf(steps, looked);
  let best: number | null = null;
  let nearest = reach;
  let cuts = false;
  const side = (i: number, which: number) => sides[i * SIDES + which] ?? 0;
  steps.forEach((step, i) => {
    if (place.z < side(i, 0) - reach || place.z > side(i, 1) + reach) return;
    if (place.r < side(i, 2) - reach || place.r > side(i, 3) + reach || !shown(i)) return;
    const d = part.distanceTo(looked.wayOf(step), place),
      cutting = looked.cuts(step);
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

/** Fraction of a step's way that is nearest to a place: 0 … 1, but never its very end. */
export function fractionNear(way: Segment, place: Pt): number {
  const long = part.lengthOf(way);
  const done = long > 0 ? part.along(way, part.nearestOn(way, place)) / long : 0;
  return Math.min(ALMOST_DONE, Math.max(0, done));
}

const TURNED: StepAccess<Step> = {
  wayOf: ({ from, move }) => pathOf(from, move),
  cuts: ({ move }) => move.kind !== "rapid",
};

/** The turned move nearest to a place. */
export const moveAt = (
  steps: readonly Step[],
  place: Pt,
  reach: number,
  shown?: (step: number) => boolean,
): number | null => nearestStep(steps, TURNED, place, reach, shown);

/** The moment at which the tip is nearest to a place while it makes a move. */
export function positionNear(steps: readonly Step[], step: number, place: Pt): PlayPosition {
  const made = steps[step];
  return { step, fraction: made ? fractionNear(TURNED.wayOf(made), place) : 0 };
}
