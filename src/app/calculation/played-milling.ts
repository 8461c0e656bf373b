import type { MilledStock } from "../../sim/plane/milled.ts";
import { milledPainter, type MilledLook } from "../../view/approach/milled-painter.ts";
import { trackOf } from "../../view/playback.ts";
import { cutFor, uncutStock } from "./cut-milled.ts";
import type { Outcome } from "./outcome.ts";
import type { Playable } from "./played.ts";

interface Milled extends Playable<MilledLook> {
  readonly stock: MilledStock;
}
const known = new WeakMap<Outcome, Milled | null>();

/** Slice of cutting between other requests to the worker, ms. */
const SLICE = 12;
const turn = (): Promise<void> => new Promise((done) => setTimeout(done, 0));

/** Cuts until all is cut, or another result is requested. */
async function cutAll(outcome: Outcome, { stock }: Milled): Promise<void> {
  while (asked === outcome && !cutFor(stock, SLICE)) await turn();
}
let asked: Outcome | null = null;

function milledOf(outcome: Outcome): Milled | null {
  const { plane } = outcome.run,
    stock = uncutStock(outcome.run, outcome.simulation);
  if (typeof stock === "string") return null;
  return {
    stock,
    painter: () => milledPainter(plane, stock),
    track: trackOf(plane),
    async reaches(step) {
      while (asked === outcome && stock.reached() < Math.min(step, plane.length)) await turn();
      return asked === outcome;
    },
  };
}

/** The milled stock of a result, cut once it is asked for; null if it has none. */
export function playedMilling(outcome: Outcome): Playable<MilledLook> | null {
  const isNew = asked !== outcome;
  asked = outcome;
  if (!known.has(outcome)) known.set(outcome, milledOf(outcome));
  const milled = known.get(outcome) ?? null;
  if (isNew && milled) void cutAll(outcome, milled);
  return milled;
}
