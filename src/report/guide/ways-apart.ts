import { part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { pathOf } from "../../kernel/time/time.ts";
import type { Run } from "../../program/state/run-types.ts";

/** Ways nearer than this lie on each other in a picture, mm. */
const ON_EACH_OTHER = 0.05;
/**
 * Places that are looked at on a way, and on all ways of a run together: an own program may have thousands of moves.
 */
const PLACES = [0, 0.2, 0.4, 0.6, 0.8, 1];
const MOST_PLACES = 240;

/** The ways of the tool in the cycles of a run. */
const waysOf = (run: Run): readonly Segment[] =>
  run.steps.flatMap(({ from, move, operation }) => (operation === null ? [] : [pathOf(from, move)]));

const keyOf = (way: Segment) => JSON.stringify(way);

/** Ways of the first that no way of the second lies on, each with the greatest distance found, mm. */
function missing(
  ways: readonly Segment[],
  others: readonly Segment[],
): { readonly way: Segment; readonly apart: number }[] {
  const same = new Set(others.map(keyOf));
  const different = ways.filter((way) => !same.has(keyOf(way)));
  const stride = Math.max(1, Math.ceil((different.length * PLACES.length) / MOST_PLACES));
  const apart = (place: Pt) => {
    let nearest = Infinity;
    for (const other of others) {
      nearest = Math.min(nearest, part.distanceTo(other, place));
      if (nearest < ON_EACH_OTHER) return 0;
    }
    return nearest;
  };
  return different
    .filter((_, i) => i % stride === 0)
    .flatMap((way) => {
      const most = Math.max(...PLACES.map((share) => apart(part.pointOn(way, share))));
      return most > 0 ? [{ way, apart: most }] : [];
    });
}

/**
 * How far the tool leaves in one run the ways that it has in the other, mm; 0 where both go the same ways, in whatever
 * order.
 */
export function waysApart(a: Run, b: Run): number {
  const [one, other] = [waysOf(a), waysOf(b)];
  if (one.length === 0 || other.length === 0) return 0;
  return Math.max(
    0,
    ...missing(one, other).map(({ apart }) => apart),
    ...missing(other, one).map(({ apart }) => apart),
  );
}

/** The ends of the ways that one run has and the other has not. */
export function ownWays(a: Run, b: Run): readonly Pt[] {
  const others = waysOf(b);
  return others.length === 0 ? [] : missing(waysOf(a), others).flatMap(({ way }) => [way.from, way.to]);
}
