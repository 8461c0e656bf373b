import { useEffect, useMemo, useState } from "react";
import type { MilledStock, RapidThrough } from "../../../sim/plane/milled.ts";
import { boundsOf, grownBounds } from "../../../view/bounds.ts";
import type { Bounds } from "../../../view/camera.ts";
import type { LatheResult } from "../lathe/use-material.ts";
import { cutFor, uncutStock, type NoStock } from "../../calculation/cut-milled.ts";

/** Milled stock that is cut bit by bit while the page rests between two pictures. */
export interface GrowingStock {
  readonly stock: MilledStock;
  /** The box round the blank, with a little air. */
  readonly blank: Bounds | null;
  /** Calls when more of it is cut; returns what ends it. */
  readonly subscribe: (listener: () => void) => () => void;
}

/** How long is cut between two pictures, and rested then, ms. */
const SLICE = { cuts: 6, rests: 4 } as const;

/** Air round the blank, mm per mm of it. */
const AIR = 0.03;

function growing(
  run: LatheResult["run"],
  simulation: LatheResult["simulation"],
): { readonly stock: MilledStock; readonly listeners: Set<() => void> } | NoStock {
  const stock = uncutStock(run, simulation);
  return typeof stock === "string" ? stock : { stock, listeners: new Set() };
}

const NO_RAPIDS: readonly RapidThrough[] = [];

/** The stock that the tool of a milled program leaves, and the rapids through it as soon as all of it is cut. */
export function useMilledStock(result: LatheResult): {
  readonly milled: GrowingStock | NoStock;
  readonly rapids: readonly RapidThrough[];
} {
  const [held, hold] = useState(result);
  // What turning leaves is known when that is proved; until then the stock of before stays.
  const newest = result.simulation || result.run.steps.length === 0 ? result : held;
  if (newest !== held) hold(newest);
  // A proof says nothing new of a program that does not turn: what is cut for its path stays.
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
