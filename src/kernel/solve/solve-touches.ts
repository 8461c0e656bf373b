import { part, type Pt } from "../geometry/point.ts";
import { tangent, towards } from "./solve-curves.ts";
import { aside, place, pointOf, same, type Circle, type Solving } from "./solve-work.ts";
import { SAME } from "../tolerance.ts";

const { angleOf, apart, difference, heading, onCircle } = part;

/** Finds points where a known circle touches its tangential neighbour. */
export function findTouches(w: Solving): boolean {
  let changed = false;
  w.elements.forEach((_, i) => {
    const circle = w.circle[i] ?? null;
    if (!circle || circle === "straight") return;
    for (const [other, p, far] of [
      [i - 1, i - 1, i - 2],
      [i + 1, i, i + 1],
    ] as const) {
      if (other < 1 || !tangent(w, Math.max(i, other)) || pointOf(w, p)) continue;
      const found = touchOf(w, circle, other, far, other > i);
      if (found) changed = place(w, p, found) || changed;
    }
  });
  return changed;
}

/** Point where a circle touches its tangential neighbour; `after`: the neighbour follows. */
function touchOf(w: Solving, { centre, radius, turn }: Circle, other: number, far: number, after: boolean): Pt | null {
  const next = w.circle[other] ?? null,
    angle = w.angle[other] ?? null,
    outside = pointOf(w, far);
  if (next && next !== "straight") {
    if (same(centre, next.centre)) return null;
    return towards(centre, next.centre, next.turn === turn && next.radius > radius ? -radius : radius);
  }
  if (angle !== null) return difference(centre, aside(turn, heading(angle), radius));
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
