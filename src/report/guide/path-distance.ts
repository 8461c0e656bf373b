import { part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { pathOf } from "../../kernel/time/time.ts";
import type { Run } from "../../program/state/run-types.ts";

/** Paths nearer than this coincide in a picture, mm. */
const ON_EACH_OTHER = 0.05;
/** Sample points on a path, and on all paths of a run: an own program may have thousands of moves. */
const PLACES = [0, 0.2, 0.4, 0.6, 0.8, 1];
const MOST_PLACES = 240;

/** The tool paths in the cycles of a run. */
const waysOf = (run: Run): readonly Segment[] =>
  run.steps.flatMap(({ from, move, operation }) => (operation === null ? [] : [pathOf(from, move)]));

const keyOf = (way: Segment) => JSON.stringify(way);

/** Paths of the first run that coincide with none of the second, each with the greatest distance found, mm. */
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

/** The greatest distance between the tool paths of two runs, mm; 0 where both have the same paths, in any order. */
export function pathDistance(a: Run, b: Run): number {
  const [one, other] = [waysOf(a), waysOf(b)];
  if (one.length === 0 || other.length === 0) return 0;
  return Math.max(
    0,
    ...missing(one, other).map(({ apart }) => apart),
    ...missing(other, one).map(({ apart }) => apart),
  );
}

/** The ends of the paths of one run that the other does not have. */
export function ownPathEnds(a: Run, b: Run): readonly Pt[] {
  const others = waysOf(b);
  return others.length === 0 ? [] : missing(waysOf(a), others).flatMap(({ way }) => [way.from, way.to]);
}
