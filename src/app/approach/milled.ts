import { useEffect, useMemo, useState } from "react";
import type { Run } from "../../program/run-types.ts";
import { milledStock, type MilledInput, type MilledStock, type RapidThrough } from "../../sim/plane/milled.ts";
import { playerOf } from "../../sim/stock.ts";
import { boundsOf, grownBounds } from "../../view/bounds.ts";
import type { Bounds } from "../../view/camera.ts";
import { stopwatch } from "../clock.ts";
import type { LatheResult } from "../lathe/use-material.ts";

/** Milled stock that is cut bit by bit while the page rests between two pictures. */
export interface GrowingStock {
  readonly stock: MilledStock;
  /** The box round the blank, with a little air. */
  readonly blank: Bounds | null;
  /** Calls when more of it is cut; returns what ends it. */
  readonly subscribe: (listener: () => void) => () => void;
}

/** Why no stock is drawn: the program has no blank for it, or too many motions. */
export type NoStock = "noBlank" | "tooLong";

/** A path of more motions is drawn without its stock. */
export const MOST_MILLED = 30_000;

/** How long is cut between two pictures, and rested then, ms; and motions between two looks at the watch. */
const SLICE = { cuts: 6, rests: 4, motions: 2 } as const;

/** Air round the blank, mm per mm of it. */
const AIR = 0.03;

/** The blank as turning leaves it before each milled stretch; the box of BLK FORM is milled as the box that it is. */
function bodiesOf({ plane, steps, blank, cuboid }: Run, simulation: LatheResult["simulation"]): MilledInput["bodies"] {
  const player = simulation && steps.length > 0 ? playerOf(simulation) : null;
  return plane.flatMap(({ turned }, step) => {
    if (step > 0 && plane[step - 1]?.turned === turned) return [];
    const section = player ? player.at({ step: turned, fraction: 0 }) : blank;
    return [{ step, body: { block: cuboid, turned: section.length > 0 ? section : null } }];
  });
}

function growing({ run, simulation }: LatheResult): { readonly stock: MilledStock; readonly listeners: Set<() => void> } | NoStock {
  if (run.plane.length > MOST_MILLED) return "tooLong";
  const stock = milledStock({ motions: run.plane, bodies: bodiesOf(run, simulation) });
  return stock ? { stock, listeners: new Set() } : "noBlank";
}

const NO_RAPIDS: readonly RapidThrough[] = [];

/** The stock that the tool of a milled program leaves, and the rapids through it as soon as all of it is cut. */
export function useMilledStock(result: LatheResult): { readonly milled: GrowingStock | NoStock; readonly rapids: readonly RapidThrough[] } {
  const [held, hold] = useState(result);
  // What turning leaves is known when that is proved; until then the stock of before stays.
  const newest = result.simulation || result.run.steps.length === 0 ? result : held;
  if (newest !== held) hold(newest);
  const made = useMemo(() => growing(newest), [newest]);
  const [done, setDone] = useState<MilledStock | null>(null);
  useEffect(() => {
    if (typeof made === "string") return undefined;
    let timer: ReturnType<typeof setTimeout> | undefined;
    const slice = () => {
      const until = stopwatch() + SLICE.cuts;
      let all = false;
      while (!all && stopwatch() < until) all = made.stock.advance(SLICE.motions);
      for (const listener of [...made.listeners]) listener();
      if (all) setDone(made.stock);
      else timer = setTimeout(slice, SLICE.rests);
    };
    timer = setTimeout(slice, 0);
    return () => clearTimeout(timer);
  }, [made]);
  return useMemo(() => {
    if (typeof made === "string") return { milled: made, rapids: NO_RAPIDS };
    const subscribe = (listener: () => void) => {
      made.listeners.add(listener);
      return () => void made.listeners.delete(listener);
    };
    const box = boundsOf(made.stock.at({ step: 0, fraction: 0 }).standing.flat(2)),
      blank = box && grownBounds(box, AIR * (box.right - box.left));
    return { milled: { stock: made.stock, blank, subscribe }, rapids: done === made.stock ? made.stock.rapids() : NO_RAPIDS };
  }, [made, done]);
}
