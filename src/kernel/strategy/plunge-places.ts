import { heightAt, type Envelope } from "../reach/envelope.ts";
import type { Flat } from "../geometry/flat.ts";
import { SAME } from "../tolerance.ts";
import type { Basin } from "./basins.ts";
import { partsOf } from "./infeed.ts";

/** Spacing of plunges, mm. */
export interface Spacing {
  /** Width of one plunge: that of the edge. */
  readonly width: number;
  /** Width of the level floor under a plunge, which bounds the spacing; 0 for a round edge. */
  readonly level: number;
  /** The widest side step; in a comb the widest web. */
  readonly step: number;
  /** True: first cuts with webs between them, then the webs. */
  readonly comb: boolean;
}

/** Plunges of a basin in cutting order. */
export interface Places {
  readonly full: readonly Flat[];
  readonly webs: readonly Flat[];
}

/** Greatest distance from one plunge to the next, mm. */
export const reachOfStep = ({ width, level, step, comb }: Spacing): number => {
  const most = comb ? (width + step) / 2 : step;
  // Rounded corners leave crests between two plunges, unless the level parts of the edge meet.
  return level >= width / 2 ? Math.min(most, level) : most;
};

/**
 * Positions of the plunges in a basin: at its stops, and evenly between them and its ends, no farther apart than a
 * step. They begin where the floor does, continue to the far wall, and come back for the near one: so every plunge
 * after the first has a free side.
 */
export function placesIn(basin: Basin, e: Envelope, s: Spacing): Places {
  const [full, webs]: [Flat[], Flat[]] = [[], []];
  const most = reachOfStep(s);
  // An inclined wall ends where there is nothing left to plunge: no stop, but its slope is divided as well.
  const ends = [basin.from, ...basin.stops.map((p) => p.u), basin.to].filter(
    (u, i, all) => i === 0 || u > (all[i - 1] ?? u) + SAME,
  );
  ends.forEach((u, i) => {
    const before = ends[i - 1];
    if (before !== undefined) {
      const apart = u - before;
      const least = partsOf(apart, most);
      const count = s.comb && least > 1 ? least + (least % 2) : least;
      for (let k = 1; k < count; k += 1) {
        const between = before + (apart * k) / count;
        const place = { u: between, v: heightAt(e, between) };
        const isWeb = s.comb && k % 2 === 1;
        if (!isWeb) full.push(place);
        else if ((2 * apart) / count > s.level + SAME) webs.push(place);
      }
    }
    const stop = basin.stops.find((p) => Math.abs(p.u - u) <= SAME);
    if (stop) full.push(stop);
  });
  return { full: fromFloor(full, basin), webs: fromFloor(webs, basin) };
}

const fromFloor = (places: readonly Flat[], { floor }: Basin): Flat[] => [
  ...places.filter((p) => p.u > floor.from - SAME),
  ...places.filter((p) => p.u <= floor.from - SAME).toReversed(),
];
