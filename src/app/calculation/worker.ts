import { expose, transfer } from "comlink";
import { z } from "zod/mini";
import { motionsOf, type MachineSide } from "../../program/run/plane-index.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import type { advice } from "./advice.ts";
import type { BodiesGiven, BodiesWanted } from "./bodies.ts";
import { engine } from "./engine.ts";
import { loadRequestOf, type KnownOutcome, type KnownSide, type LoadRequest } from "./load-request.ts";
import { openWork } from "./open-work.ts";
import type * as DrawingsPart from "./opened-drawing.ts";
import type { Outcome } from "./outcome.ts";
import type { Looks, Playable, PlayedCourse, PlaybackCanvas, StockPictures } from "./played.ts";
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

const playables: {
  readonly [Side in MachineSide]: () => Promise<(outcome: Outcome) => Playable<Looks[Side]> | null>;
} = {
  lathe: async () => (await import("./played-turning.ts")).playedTurning,
  plane: async () => (await import("./played-milling.ts")).playedMilling,
};

/** The newest result, if it is the known one, as one of its pictures plays it. */
async function playableOf<Side extends MachineSide>({ side, version, moves }: KnownSide<Side>) {
  const newest = work.newest();
  if (newest?.version !== version || motionsOf(newest.run, side).length !== moves) return null;
  return (await playables[side]())(newest);
}

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
  async play<Side extends MachineSide>(
    of: KnownSide<Side>,
    on: PlaybackCanvas,
    look: Looks[Side],
    course: PlayedCourse,
  ): Promise<boolean> {
    const played = await playableOf(of);
    return played !== null && (await (await fetchPlayed()).play(played, on, look, course));
  },
  /** Paints the newest result at a position; null if another one is requested. */
  async stockPictures<Side extends MachineSide>(
    of: KnownSide<Side>,
    look: Looks[Side],
    position: PlayPosition,
  ): Promise<StockPictures | null> {
    const played = await playableOf(of),
      made = played && (await (await fetchPlayed()).stockPictures(played, look, position));
    return (
      made &&
      transfer(
        made,
        [made.work, made.shop].filter((each) => each !== null),
      )
    );
  },
  /** The turned bodies of the newest result at a position; null if another one is requested. */
  async bodies(of: KnownOutcome, wanted: BodiesWanted): Promise<BodiesGiven | null> {
    const { turnedBodies, buffersOf } = await import("./bodies.ts"),
      outcome = knownTurning(of);
    if (!outcome) return null;
    const made = turnedBodies(outcome, wanted);
    return made === "same" ? made : transfer(made, buffersOf(made));
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
