import type { Run } from "../../program/state/run-types.ts";
import type { Simulation } from "../../sim/simulation.ts";
import { milledStock, type MilledInput, type MilledStock } from "../../sim/plane/milled.ts";
import { playerOf } from "../../sim/stock.ts";
import { stopwatch } from "../base/clock.ts";

/** Why no stock is drawn: the program has no blank for it, or too many motions. */
export type NoStock = "noBlank" | "tooLong";

/** Longer paths are drawn without stock, motions. */
export const MOST_MILLED = 30_000;

/** Motions that are cut between two time checks. */
const MOTIONS = 2;

/** The stock as turning leaves it before each milled section; the box of BLK FORM is milled as a box. */
function bodiesOf({ plane, steps, blank, cuboid }: Run, simulation: Simulation | null): MilledInput["bodies"] {
  const player = simulation && steps.length > 0 ? playerOf(simulation) : null;
  return plane.flatMap(({ turned }, step) => {
    if (step > 0 && plane[step - 1]?.turned === turned) return [];
    const section = player ? player.at({ step: turned, fraction: 0 }) : blank;
    return [{ step, body: { block: cuboid, turned: section.length > 0 ? section : null } }];
  });
}

/** The stock of a run before any milling. */
export function uncutStock(run: Run, simulation: Simulation | null): MilledStock | NoStock {
  if (run.plane.length > MOST_MILLED) return "tooLong";
  return milledStock({ motions: run.plane, bodies: bodiesOf(run, simulation) }) ?? "noBlank";
}

/** Continues cutting for `time` ms; true when all is cut. */
export function cutFor(stock: MilledStock, time: number): boolean {
  const until = stopwatch() + time;
  let all = false;
  do all = stock.advance(MOTIONS);
  while (!all && stopwatch() < until);
  return all;
}
