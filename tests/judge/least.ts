import { filled, type Field, type Grid } from "./field.ts";
import type { P } from "./insert.ts";
import { THIN } from "./judge.ts";

/*
 * The least residual material that an insert can leave on a part, found without a strategy: the insert is placed at
 * every position along the columns, as deep as the part allows from the open side; the area that it never covers
 * remains.
 */

/** Additional columns beside the judged ones, as wide as an insert. */
const BESIDE = 500;

/** Orientation of heights: columns run along `along`, and the open side is up (1) or down (−1) in them. */
export interface Open {
  readonly along: Grid["along"];
  readonly out: 1 | -1;
}

/** The side of an insert that faces the part, by column from its first one. */
interface LowerSide {
  readonly first: number;
  readonly low: readonly number[];
}

function lowerSide(insert: readonly P[], { along, out }: Open, width: number): LowerSide {
  const corners = insert.map((p) => (along === "z" ? { on: p.z, up: out * p.r } : { on: p.r, up: out * p.z }));
  const first = Math.ceil(Math.min(...corners.map((p) => p.on)) / width);
  const last = Math.floor(Math.max(...corners.map((p) => p.on)) / width);
  const low = Array.from({ length: last - first + 1 }, () => Infinity);
  corners.forEach((a, i) => {
    const b = corners[(i + 1) % corners.length] as typeof a;
    if (a.on === b.on) return;
    const [from, to] = [Math.min(a.on, b.on), Math.max(a.on, b.on)];
    for (let k = Math.max(first, Math.ceil(from / width)); k <= Math.min(last, Math.floor(to / width)); k += 1) {
      const up = a.up + ((b.up - a.up) * (k * width - a.on)) / (b.on - a.on);
      low[k - first] = Math.min(low[k - first] as number, up);
    }
  });
  return { first, low };
}

/** The height of a part by column, and the least remaining height over it. */
function leastOver(surface: readonly number[], { first, low }: LowerSide): number[] {
  const left = surface.map(() => Infinity);
  for (let tip = -low.length; tip < surface.length + low.length; tip += 1) {
    let depth = -Infinity;
    low.forEach((v, i) => {
      depth = Math.max(depth, (surface[tip + first + i] ?? -Infinity) - v);
    });
    low.forEach((v, i) => {
      const k = tip + first + i;
      if (k >= 0 && k < left.length) left[k] = Math.min(left[k] as number, depth + v);
    });
  }
  return left;
}

/**
 * The residual material of an insert over a part in the columns of a grid, down to the height `deep`. Walls count as
 * one column thicker, which is the resolution of columns: otherwise the insert would reach far too deep between two
 * steep walls.
 */
export function least(part: readonly P[], insert: readonly P[], open: Open, grid: Grid, deep: number): Field {
  const wide: Grid = { ...grid, from: grid.from - BESIDE * grid.width, count: grid.count + 2 * BESIDE };
  const surface = filled(wide, [part]).map((spans) =>
    open.out > 0 ? (spans.at(-1) ?? -Infinity) : -(spans[0] ?? Infinity),
  );
  const thick = surface.map((v, i) => Math.max(v, surface[i - 1] ?? -Infinity, surface[i + 1] ?? -Infinity));
  return leastOver(thick, lowerSide(insert, open, grid.width))
    .slice(BESIDE, BESIDE + grid.count)
    .map((v): number[] => (open.out > 0 ? [deep, Math.max(deep, v + THIN)] : [Math.min(-v - THIN, deep), deep]));
}
