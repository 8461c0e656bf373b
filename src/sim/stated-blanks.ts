import { areaOf } from "../kernel/area/area.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import { areaOutside } from "../kernel/area/real-area.ts";
import type { StatedBlank, UnsimulatedBlock } from "../kernel/time/step.ts";
import type { Cutting } from "./cutting.ts";
import type { StatedProof } from "./simulation.ts";

/** Blanks stated during a run, compared with the stock at that moment. */
export interface StatedBlanks {
  /** The new stock from a step on, where a stated blank changes it; null: unchanged. */
  at(step: number, cut: Cutting): readonly Ring[] | null;
  all(): readonly StatedProof[];
  /** Total change of the stock by stated blanks, mm². */
  added(): number;
  unproved(): readonly UnsimulatedBlock[];
}

/**
 * Cut material does not come back: a larger outline changes nothing. A smaller one is accepted, since the work may have
 * been turned round or milled, and everything after it is unverified.
 */
export function statedBlanks(stated: readonly StatedBlank[]): StatedBlanks {
  const proofs: StatedProof[] = [];
  const unproved: UnsimulatedBlock[] = [];
  let [next, added] = [0, 0];
  return {
    at(step, cut) {
      let now: readonly Ring[] | null = null;
      for (let s = stated[next]; s && s.step <= step; s = stated[next]) {
        next += 1;
        const before = now ?? cut.stock();
        const { block, what, rings, file } = s;
        const [missingArea, extraArea] = [areaOutside(before, rings), areaOutside(rings, before)];
        proofs.push({ step, block, what, missingArea, extraArea });
        if (missingArea === 0) continue;
        unproved.push({ step, block, what, ...(file !== undefined && { file }) });
        added += areaOf(rings) - areaOf(before);
        now = rings;
      }
      return now;
    },
    all: () => proofs,
    added: () => added,
    unproved: () => unproved,
  };
}
