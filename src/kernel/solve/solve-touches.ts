import { part, type Pt } from "../geometry/point.ts";
import { isTangent, pointTowards } from "./solve-curves.ts";
import { centreOffset, setFoundPoint, pointOf, isSamePoint, type Circle, type SolveState } from "./solve-work.ts";
import { SAME } from "../tolerance.ts";

const { angleOf, apart, difference, heading, onCircle } = part;

/** Finds points where a known circle touches its tangential neighbour. */
export function findTouches(w: SolveState): boolean {
  let changed = false;
  w.elements.forEach((_, i) => {
    const circle = w.circle[i] ?? null;
    if (!circle || circle === "straight") return;
    for (const [other, p, far] of [
      [i - 1, i - 1, i - 2],
      [i + 1, i, i + 1],
    ] as const) {
      if (other < 1 || !isTangent(w, Math.max(i, other)) || pointOf(w, p)) continue;
      const found = touchOf(w, circle, other, far, other > i);
      if (found) changed = setFoundPoint(w, p, found) || changed;
    }
  });
  return changed;
}

/** Point where a circle touches its tangential neighbour; `after`: the neighbour follows. */
function touchOf(
  w: SolveState,
  { centre, radius, turn }: Circle,
  other: number,
  far: number,
  after: boolean,
): Pt | null {
  const next = w.circle[other] ?? null,
    angle = w.angle[other] ?? null,
    outside = pointOf(w, far);
  if (next && next !== "straight") {
    if (isSamePoint(centre, next.centre)) return null;
    return pointTowards(centre, next.centre, next.turn === turn && next.radius > radius ? -radius : radius);
  }
  if (angle !== null) return difference(centre, centreOffset(turn, heading(angle), radius));
  if (!outside || w.elements[other]?.kind !== "line") return null;
  const gap = apart(outside, centre);
  if (gap <= radius + SAME) {
    w.unreachable.add(other);
    return null;
  }
  // The centre is on the side of the turn, seen along the line; this holds for only one of the two tangents from a
  // point.
  const lean = Math.acos(radius / gap) * ((turn === "ccw") === after ? 1 : -1);
  return onCircle(centre, radius, angleOf(difference(outside, centre)) - lean);
}
