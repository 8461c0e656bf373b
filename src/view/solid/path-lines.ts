import { part, type Segment } from "../../kernel/geometry/point.ts";
import type { Step } from "../../kernel/time/step.ts";
import { pathOf } from "../../kernel/time/time.ts";
import { PATH_ROLES, pathRole, type PathRole } from "../scene.ts";

/** How far a chord may leave its arc, mm. */
const FLAT = 0.02;

/** Lines in the plane in which the tool works, as straight pieces. */
export interface SpaceLines {
  /** x, y and z of both ends of each piece, mm; the last piece of a way comes first. */
  readonly places: Float32Array;
  /** For each piece the index of what it was made from. */
  readonly sources: Int32Array;
}

/** Paths as pieces in space, from the last to the first, so that upcoming pieces are always at the beginning. */
function linesOf(paths: readonly { readonly path: Segment; readonly source: number }[]): SpaceLines {
  const places: number[] = [],
    sources: number[] = [];
  for (let i = paths.length - 1; i >= 0; i -= 1) {
    const { path, source } = paths[i] as (typeof paths)[number],
      points = part.flattened(path, FLAT);
    for (let k = points.length - 1; k > 0; k -= 1) {
      const [from, to] = [points[k - 1], points[k]];
      if (!from || !to || (from.z === to.z && from.r === to.r)) continue;
      places.push(to.r, 0, to.z, from.r, 0, from.z);
      sources.push(source);
    }
  }
  return { places: Float32Array.from(places), sources: Int32Array.from(sources) };
}

/** The moves that are shown, by the form of their lines; sources are their steps. */
export function pathInSpace(
  steps: readonly Step[],
  shown: (step: number) => boolean,
): readonly (SpaceLines & { readonly role: PathRole })[] {
  const paths = new Map<PathRole, { path: Segment; source: number }[]>();
  steps.forEach(({ from, move }, source) => {
    if (!shown(source)) return;
    const role = pathRole(move),
      list = paths.get(role) ?? [];
    paths.set(role, list);
    list.push({ path: pathOf(from, move), source });
  });
  return PATH_ROLES.flatMap((role) => ({ role, ...linesOf(paths.get(role) ?? []) })).filter(
    ({ sources }) => sources.length > 0,
  );
}

/** Any lines and arcs of the half plane; sources are their places in the list. */
export const segmentsInSpace = (segments: readonly Segment[]): SpaceLines =>
  linesOf(segments.map((path, source) => ({ path, source })));

/** How many pieces belong to a step or a later one; they come first. */
export function piecesFrom({ sources }: SpaceLines, step: number): number {
  let [low, high] = [0, sources.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((sources[middle] ?? 0) >= step) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Cells that a coordinate may fall into: four of them make one whole number. */
const CELLS = 2 ** 13;

/**
 * Only the pieces that can be told apart if ends in the same square of `fine` mm count as one place; of several equal
 * pieces, the one made last. All pieces if they span too many squares.
 */
export function thinned(lines: SpaceLines, fine: number): SpaceLines {
  const { places, sources } = lines;
  let [least, most] = [Infinity, -Infinity];
  for (const place of places) [least, most] = [Math.min(least, place), Math.max(most, place)];
  if (!(most - least < fine * CELLS)) return lines;
  const cell = (place = 0): number => Math.floor((place - least) / fine),
    seen = new Set<number>(),
    kept: number[] = [];
  for (let i = 0; i < sources.length; i += 1) {
    const at = 6 * i,
      from = cell(places[at]) * CELLS + cell(places[at + 2]),
      to = cell(places[at + 3]) * CELLS + cell(places[at + 5]);
    const key = Math.min(from, to) * CELLS * CELLS + Math.max(from, to);
    if (!seen.has(key)) kept.push(i);
    seen.add(key);
  }
  const out = { places: new Float32Array(6 * kept.length), sources: Int32Array.from(kept, (i) => sources[i] ?? 0) };
  kept.forEach((i, k) => out.places.set(places.subarray(6 * i, 6 * i + 6), 6 * k));
  return out;
}
