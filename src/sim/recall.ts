import type { Ring } from "../kernel/geometry/point.ts";
import { sameRings } from "./same-step.ts";

/** Remembers what was made of areas in one simulation for the next. */
export interface Recall<Made> {
  /** What is made of an area: the same rings, point by point, are asked about once. */
  of(area: readonly Ring[]): Made;
  /** Another simulation begins: what the one before has not asked for is forgotten. */
  next(): void;
}

interface Known<Made> {
  readonly area: readonly Ring[];
  readonly made: Made;
}

/** Spreads the numbers of a hash. */
const SPREAD = 0x01000193;

/** Gives a number for each area; equal areas have the same. */
function hashing(): (area: readonly Ring[]) => number {
  const number = new Float64Array(1),
    words = new Int32Array(number.buffer);
  const mixed = (hash: number, value: number): number => {
    number[0] = value;
    return Math.imul(Math.imul(hash ^ (words[0] ?? 0), SPREAD) ^ (words[1] ?? 0), SPREAD);
  };
  return (area) => {
    let hash = area.length;
    for (const ring of area) {
      hash = mixed(hash, ring.length);
      for (const { z, r } of ring) hash = mixed(mixed(hash, z), r);
    }
    return hash;
  };
}

/** Begins to remember what a pure function makes of areas. */
export function recalling<Made>(make: (area: readonly Ring[]) => Made): Recall<Made> {
  const hashOf = hashing();
  let [now, before]: [Map<number, Known<Made>[]>, ReadonlyMap<number, readonly Known<Made>[]>] = [new Map(), new Map()];
  return {
    of(area) {
      const hash = hashOf(area);
      const isSame = (known: Known<Made>) => sameRings(known.area, area);
      const own = now.get(hash)?.find(isSame);
      if (own) return own.made;
      const known = before.get(hash)?.find(isSame) ?? { area, made: make(area) };
      now.set(hash, [...(now.get(hash) ?? []), known]);
      return known.made;
    },
    next() {
      [now, before] = [new Map(), now];
    },
  };
}
