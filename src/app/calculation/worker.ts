import { expose, transfer } from "comlink";
import { z } from "zod/mini";
import type { PlayPosition } from "../../sim/simulation.ts";
import type { MilledLook } from "../../view/approach/milled-painter.ts";
import type { StockLook } from "../../view/material/stock-painter.ts";
import type { advice } from "./advice.ts";
import type { BodiesGiven, BodiesWanted } from "./bodies.ts";
import { engine } from "./engine.ts";
import { loadRequestOf, type KnownMilling, type KnownOutcome, type LoadRequest } from "./load-request.ts";
import { openWork } from "./open-work.ts";
import type * as DrawingsPart from "./opened-drawing.ts";
import type { Outcome } from "./outcome.ts";
import type { PlayedCourse, PlaybackCanvas, StockPictures } from "./played.ts";
import type { planOfPart, tryValues } from "./part-plan.ts";
import type { comparedWithPlan } from "./plan-comparison.ts";
import type { reported } from "./reported.ts";
import { wireOutcomes } from "./wire.ts";

z.config({ jitless: true });
wireOutcomes();

// Held while this worker lives, under its name: so the page learns when it has ended.
void navigator.locks?.request(self.name, () => new Promise<void>(() => undefined));

const work = openWork();

const knownRequest = ({ version, moves }: KnownOutcome): LoadRequest | null => {
  const newest = work.newest();
  return newest?.version === version && newest.run.steps.length === moves ? loadRequestOf(newest) : null;
};
const requestOf = (of: KnownOutcome | LoadRequest) => ("moves" in of ? knownRequest(of) : of);
const knownTurning = (of: KnownOutcome): Outcome | null => (knownRequest(of) ? work.newest() : null);

type Advice = typeof advice;
const fetchAdvice = async (): Promise<Advice> => (await import("./advice.ts")).advice;

type Drawings = typeof DrawingsPart;
const fetchDrawings = (): Promise<Drawings> => import("./opened-drawing.ts");

const fetchPlan = () => import("./part-plan.ts");
const fetchPlayed = () => import("./played.ts");
const fetchMilling = () => import("./played-milling.ts");

const knownMilling = ({ version, motions }: KnownMilling): Outcome | null => {
  const newest = work.newest();
  return newest?.version === version && newest.run.plane.length === motions ? newest : null;
};

/** The functions that the page can call: what every work needs is loaded at once, advice on first use. */
const served = {
  ...engine,
  update: work.update,
  planned: work.planned,
  proved: work.proved,
  knows: (known: KnownOutcome) => knownRequest(known) !== null,
  pathLoad: async (of: KnownOutcome | LoadRequest) => {
    const request = requestOf(of);
    return request && (await import("./load.ts")).pathLoad(request);
  },
  roughness: async (of: KnownOutcome | LoadRequest) => {
    const request = requestOf(of);
    return request && (await import("./load.ts")).roughness(request);
  },
  /** Paints the stock of the newest result during playback; false if it cannot. */
  async play(of: KnownOutcome, on: PlaybackCanvas, look: StockLook, course: PlayedCourse): Promise<boolean> {
    const outcome = knownTurning(of);
    return outcome !== null && (await (await fetchPlayed()).play(outcome, on, look, course));
  },
  /** Paints the newest result at a position; null if another one is requested. */
  async stockPictures(of: KnownOutcome, look: StockLook, position: PlayPosition): Promise<StockPictures | null> {
    const outcome = knownTurning(of);
    if (!outcome) return null;
    const made = (await fetchPlayed()).stockPictures(outcome, look, position);
    return transfer(made, [made.work, made.shop]);
  },
  /** The turned bodies of the newest result at a position; null if another one is requested. */
  async bodies(of: KnownOutcome, wanted: BodiesWanted): Promise<BodiesGiven | null> {
    const { turnedBodies, buffersOf } = await import("./bodies.ts"),
      outcome = knownTurning(of);
    if (!outcome) return null;
    const made = turnedBodies(outcome, wanted);
    return made === "same" ? made : transfer(made, buffersOf(made));
  },
  /** Paints the milled stock of the newest result during playback; false if it cannot. */
  async playMilling(of: KnownMilling, on: PlaybackCanvas, look: MilledLook, course: PlayedCourse): Promise<boolean> {
    const outcome = knownMilling(of);
    return outcome !== null && (await (await fetchMilling()).playMilling(outcome, on, look, course));
  },
  /** Paints the milled stock of the newest result at a position; null if another one is requested. */
  async milledPicture(of: KnownMilling, look: MilledLook, position: PlayPosition): Promise<ImageBitmap | null> {
    const outcome = knownMilling(of),
      made = outcome && (await (await fetchMilling()).milledPicture(outcome, look, position));
    return made && transfer(made, [made]);
  },
  stopPlaying: async () => (await fetchPlayed()).stopPlaying(),
  fitsOfWork: async (...asked: Parameters<Advice["fitsOfWork"]>) => (await fetchAdvice()).fitsOfWork(...asked),
  ways: async (...asked: Parameters<Advice["ways"]>) => (await fetchAdvice()).ways(...asked),
  tryWay: async (...asked: Parameters<Advice["tryWay"]>) => (await fetchAdvice()).tryWay(...asked),
  remediesOf: async (...asked: Parameters<Advice["remediesOf"]>) => (await fetchAdvice()).remediesOf(...asked),
  searchBetterWays: async (...asked: Parameters<Advice["searchBetterWays"]>) =>
    (await fetchAdvice()).searchBetterWays(...asked),
  tryBetterWay: async (...asked: Parameters<Advice["tryBetterWay"]>) => (await fetchAdvice()).tryBetterWay(...asked),
  /** Reads a drawing, and proposes the choices for its contour. */
  readDrawing: async (...asked: Parameters<Drawings["openedDrawing"]>) =>
    (await fetchDrawings()).openedDrawing(...asked),
  keepDrawing: async (...asked: Parameters<Drawings["keepDrawing"]>) => (await fetchDrawings()).keepDrawing(...asked),
  askDrawing: async (...asked: Parameters<Drawings["askDrawing"]>) => (await fetchDrawings()).askDrawing(...asked),
  planOfPart: async (...asked: Parameters<typeof planOfPart>) => (await fetchPlan()).planOfPart(...asked),
  tryValues: async (...asked: Parameters<typeof tryValues>) => (await fetchPlan()).tryValues(...asked),
  comparePlan: async (...asked: Parameters<typeof comparedWithPlan>) =>
    (await import("./plan-comparison.ts")).comparedWithPlan(...asked),
  stopPlanning: async () => (await fetchPlan()).stopPlanning(),
  reported: async (...asked: Parameters<typeof reported>) => (await import("./reported.ts")).reported(...asked),
};
expose(served);

export type Engine = typeof served;
