import { playerOf, sameBlank } from "../../sim/stock.ts";
import { stockPainter, type StockLook } from "../../view/material/stock-painter.ts";
import { trackOf } from "../../view/playback.ts";
import { surfacesOfRun } from "./moving.ts";
import type { Outcome } from "./outcome.ts";
import type { Playable } from "./played.ts";

const playables = new WeakMap<Outcome, Playable<StockLook>>();

/** The turned stock of a result: known at every step, since the simulation keeps it. */
export function playedTurning(outcome: Outcome): Playable<StockLook> {
  const known = playables.get(outcome);
  if (known) return known;
  const {
    run: { steps },
    simulation,
  } = outcome;
  const run = {
    steps,
    stockAt: playerOf(simulation).at,
    isSameBlank: sameBlank(simulation),
    surfaces: surfacesOfRun(outcome.run),
  };
  const made = { painter: () => stockPainter(run), track: trackOf(steps), reaches: () => Promise.resolve(true) };
  playables.set(outcome, made);
  return made;
}
