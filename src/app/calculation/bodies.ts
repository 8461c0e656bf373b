import type { Ring } from "../../kernel/geometry/point.ts";
import { playerOf } from "../../sim/stock.ts";
import { statedSteps } from "../../view/solid/bodies.ts";
import {
  buffersOf,
  shownBodies,
  type BodiesRequest,
  type ShownBodies,
  type TurnedRun,
} from "../../view/solid/shown-bodies.ts";
import { runThreads } from "../../view/solid/thread-cuts.ts";
import { surfacesOfRun } from "./moving.ts";
import type { Outcome } from "./outcome.ts";

/** Request of the page for each frame; `look` identifies everything but the stock that decides how it looks. */
export interface BodiesWanted extends BodiesRequest {
  readonly look: string;
  /** The page still has the last bodies: unchanged ones are not made again. */
  readonly hasLast: boolean;
}

/** The bodies, or "same" if they equal those of the last answer. */
export type BodiesGiven = ShownBodies | "same";

interface Turned {
  readonly stockAt: ReturnType<typeof playerOf>["at"];
  readonly run: TurnedRun;
  last: { readonly rings: readonly Ring[]; readonly look: string } | null;
}
const known = new WeakMap<Outcome, Turned>();

function turnedOf(outcome: Outcome): Turned {
  const have = known.get(outcome);
  if (have) return have;
  const {
    run: { steps, spindles },
    simulation,
  } = outcome;
  // Threads need the stock before them: a separate player, so that the one that follows the time need not go back.
  const threads = runThreads(steps, playerOf(simulation).at, { stated: statedSteps(simulation), spindles });
  const made: Turned = {
    last: null,
    stockAt: playerOf(simulation).at,
    run: { simulation, threads, surfaces: surfacesOfRun(outcome.run) },
  };
  known.set(outcome, made);
  return made;
}

export { buffersOf };

/** The bodies of a result at a position. */
export function turnedBodies(outcome: Outcome, { look, hasLast, ...asked }: BodiesWanted): BodiesGiven {
  const turned = turnedOf(outcome),
    rings = turned.stockAt(asked.position);
  if (hasLast && turned.last?.rings === rings && turned.last.look === look) return "same";
  turned.last = { rings, look };
  return shownBodies(rings, turned.run, asked);
}
