import type { MilledStock } from "../../sim/plane/milled.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import { milledPainter, type MilledLook } from "../../view/approach/milled-painter.ts";
import { trackOf, type PlayedTrack } from "../../view/playback.ts";
import { cutFor, uncutStock } from "./cut-milled.ts";
import type { Outcome } from "./outcome.ts";
import { painted, playPainted, type PlayedCourse, type PlaybackCanvas } from "./played.ts";

interface Milled {
  readonly stock: MilledStock;
  readonly track: PlayedTrack;
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
  const isNew = asked !== outcome;
  asked = outcome;
  if (!known.has(outcome)) {
    const stock = uncutStock(outcome.run, outcome.simulation);
    known.set(outcome, typeof stock === "string" ? null : { stock, track: trackOf(outcome.run.plane) });
  }
  const milled = known.get(outcome) ?? null;
  if (isNew && milled) void cutAll(outcome, milled);
  return milled;
}

/** Waits until all motions before a step are cut; false if another result is requested first. */
async function reaches(outcome: Outcome, { stock }: Milled, step: number): Promise<boolean> {
  while (asked === outcome && stock.reached() < Math.min(step, outcome.run.plane.length)) await turn();
  return asked === outcome;
}

/** Paints the milled stock of a result at a position; null if another result was requested meanwhile. */
export async function milledPicture(
  outcome: Outcome,
  look: MilledLook,
  position: PlayPosition,
): Promise<ImageBitmap | null> {
  const milled = milledOf(outcome);
  if (!milled || !(await reaches(outcome, milled, position.step))) return null;
  const painter = milledPainter(outcome.run.plane, milled.stock);
  painter.goTo(position);
  return painted(look.origin, look.ratio, (pen) => painter.paintAll(pen, look));
}

/** Paints the milled stock during playback. Resolves after the first frame; false if it cannot be painted. */
export async function playMilling(
  outcome: Outcome,
  on: PlaybackCanvas,
  look: MilledLook,
  course: PlayedCourse,
): Promise<boolean> {
  const milled = milledOf(outcome);
  return (
    milled !== null &&
    (await playPainted(
      { painter: milledPainter(outcome.run.plane, milled.stock), track: milled.track },
      on,
      look,
      course,
      (step) => reaches(outcome, milled, step),
    ))
  );
}
