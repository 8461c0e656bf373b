import type { Run } from "../../program/state/run-types.ts";
import type { Simulation } from "../../sim/simulation.ts";
import { milledStock, type MilledInput, type MilledStock } from "../../sim/plane/milled.ts";
import { playerOf } from "../../sim/stock.ts";
import { stopwatch } from "../base/clock.ts";

/** Why no stock is drawn: the program has no blank for it, or too many motions. */
export type NoStock = "noBlank" | "tooLong";

/** A path of more motions is drawn without its stock. */
export const MOST_MILLED = 30_000;

/** Motions that are cut between two looks at the watch. */
const MOTIONS = 2;

/** The blank as turning leaves it before each milled stretch; the box of BLK FORM is milled as the box that it is. */
function bodiesOf({ plane, steps, blank, cuboid }: Run, simulation: Simulation | null): MilledInput["bodies"] {
  const player = simulation && steps.length > 0 ? playerOf(simulation) : null;
  return plane.flatMap(({ turned }, step) => {
    if (step > 0 && plane[step - 1]?.turned === turned) return [];
    const section = player ? player.at({ step: turned, fraction: 0 }) : blank;
    return [{ step, body: { block: cuboid, turned: section.length > 0 ? section : null } }];
  });
}

/** What the mills of a run leave of its stock, of which nothing is cut yet. */
export function uncutStock(run: Run, simulation: Simulation | null): MilledStock | NoStock {
  if (run.plane.length > MOST_MILLED) return "tooLong";
  return milledStock({ motions: run.plane, bodies: bodiesOf(run, simulation) }) ?? "noBlank";
}

/** Cuts on for so many ms; true when all is cut. */
export function cutFor(stock: MilledStock, time: number): boolean {
  const until = stopwatch() + time;
  let all = false;
  do all = stock.advance(MOTIONS);
  while (!all && stopwatch() < until);
  return all;
}
