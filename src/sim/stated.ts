import { areaOf } from "../kernel/area/area.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import { areaOutside } from "../kernel/area/real-area.ts";
import type { Stated, Unproved } from "../kernel/time/step.ts";
import type { Cutting } from "./cutting.ts";
import type { StatedProof } from "./simulation.ts";

/** Blanks that a program states while it runs, held to what stands there by then. */
export interface StatedBlanks {
  /** What stands from a step on, where a blank that is stated there has another shape; null: what was left. */
  at(step: number, cut: Cutting): readonly Ring[] | null;
  all(): readonly StatedProof[];
  /** By how much they have changed the stock, mm². */
  added(): number;
  unproved(): readonly Unproved[];
}

/**
 * Material that was cut does not come back: an outline that has more than what stands changes nothing. One that lacks
 * material is believed, since the work may have been turned round or milled, and nothing is proved behind it.
 */
export function statedBlanks(stated: readonly Stated[]): StatedBlanks {
  const held: StatedProof[] = [];
  const unproved: Unproved[] = [];
  let [next, added] = [0, 0];
  return {
    at(step, cut) {
      let now: readonly Ring[] | null = null;
      for (let s = stated[next]; s && s.step <= step; s = stated[next]) {
        next += 1;
        const before = now ?? cut.stock();
        const { block, what, rings, file } = s;
        const [lacks, adds] = [areaOutside(before, rings), areaOutside(rings, before)];
        held.push({ step, block, what, lacks, adds });
        if (lacks === 0) continue;
        unproved.push({ step, block, what, ...(file !== undefined && { file }) });
        added += areaOf(rings) - areaOf(before);
        now = rings;
      }
      return now;
    },
    all: () => held,
    added: () => added,
    unproved: () => unproved,
  };
}
