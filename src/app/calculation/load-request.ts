import type { Ring } from "../../kernel/geometry/point.ts";
import type { LoadInput } from "../../sim/load/along.ts";
import type { Outcome } from "./outcome.ts";

/** What is needed to tell load and roughness of a run. */
export interface LoadRequest extends LoadInput {
  readonly final: readonly Ring[];
  /** The first step since the work is held as it is. */
  readonly first: number;
}

/** What of an outcome is looked at. */
export function loadRequestOf({
  run: { stated, steps, spindles },
  simulation: { blank, checkpoints, final },
}: Outcome): LoadRequest {
  const first = checkpoints.reduce((last, { step, isStated }) => (isStated ? step : last), 0);
  return { blank, stated, steps, spindles, final, first };
}

/** An outcome by its version and its moves, of which the first blocks of a long text have fewer. */
export interface KnownOutcome {
  readonly version: number;
  readonly moves: number;
}

/** The same by what is milled. */
export interface KnownMilling {
  readonly version: number;
  readonly motions: number;
}
