import type { Ring } from "../../kernel/geometry/point.ts";
import type { MachineSide } from "../../program/run/plane-index.ts";
import type { LoadInput } from "../../sim/load/along.ts";
import type { Outcome } from "./outcome.ts";

/** Data needed for load and roughness of a run. */
export interface LoadRequest extends LoadInput {
  readonly final: readonly Ring[];
  /** First step with the present clamping. */
  readonly first: number;
}

/** The data of a result for load and roughness. */
export function loadRequestOf({
  run: { stated, steps, spindles },
  simulation: { blank, checkpoints, final },
}: Outcome): LoadRequest {
  const first = checkpoints.reduce((last, { step, isStated }) => (isStated ? step : last), 0);
  return { blank, stated, steps, spindles, final, first };
}

/** A result, identified by its version and its moves, of which the beginning of a long text has fewer. */
export interface KnownOutcome {
  readonly version: number;
  readonly moves: number;
}

/** The same by the motions of one of its pictures. */
export interface KnownSide<Side extends MachineSide = MachineSide> extends KnownOutcome {
  readonly side: Side;
}
