import { useEffect, useMemo, useState } from "react";
import type { MilledStock, RapidThrough } from "../../../sim/plane/milled.ts";
import { boundsOf, grownBounds } from "../../../view/bounds.ts";
import type { Bounds } from "../../../view/camera.ts";
import type { LatheResult } from "../lathe/use-material.ts";
import { cutFor, uncutStock, type NoStock } from "../../calculation/cut-milled.ts";

/** Milled stock that is cut in slices while the page is idle. */
export interface GrowingStock {
  readonly stock: MilledStock;
  /** Bounds of the blank, with a margin. */
  readonly blank: Bounds | null;
  /** Calls the listener when more of it is cut; returns the function that stops it. */
  readonly subscribe: (listener: () => void) => () => void;
}

/** Duration of a slice of cutting, and of the pause after it, ms. */
const SLICE = { cuts: 6, rests: 4 } as const;

/** Margin around the blank, mm per mm of it. */
const AIR = 0.03;

function growing(
  run: LatheResult["run"],
  simulation: LatheResult["simulation"],
): { readonly stock: MilledStock; readonly listeners: Set<() => void> } | NoStock {
  const stock = uncutStock(run, simulation);
  return typeof stock === "string" ? stock : { stock, listeners: new Set() };
}

const NO_RAPIDS: readonly RapidThrough[] = [];

/** The stock that a milling program leaves, and the rapids through it once all of it is cut. */
export function useMilledStock(result: LatheResult): {
  readonly milled: GrowingStock | NoStock;
  readonly rapids: readonly RapidThrough[];
} {
  const [held, hold] = useState(result);
  // The turned stock is known after the simulation; until then the previous stock stays.
  const newest = result.simulation || result.run.steps.length === 0 ? result : held;
  if (newest !== held) hold(newest);
  // A simulation adds nothing for a program without turning, so its milled stock stays.
  const { run } = newest,
    simulation = run.steps.length > 0 ? newest.simulation : null;
  const made = useMemo(() => growing(run, simulation), [run, simulation]);
  const [done, setDone] = useState<MilledStock | null>(null);
  useEffect(() => {
    if (typeof made === "string") return undefined;
    let timer: ReturnType<typeof setTimeout> | undefined;
    const slice = () => {
      const all = cutFor(made.stock, SLICE.cuts);
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
    return {
      milled: { stock: made.stock, blank, subscribe },
      rapids: done === made.stock ? made.stock.rapids() : NO_RAPIDS,
    };
  }, [made, done]);
}
