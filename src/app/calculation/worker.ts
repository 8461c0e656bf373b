import { expose, transfer } from "comlink";
import { z } from "zod/mini";
import type { PlayPosition } from "../../sim/simulation.ts";
import type { MilledLook } from "../../view/approach/milled-painter.ts";
import type { StockLook } from "../../view/material/stock-painter.ts";
import { stopwatch } from "../base/clock.ts";
import type { advice } from "./advice.ts";
import type { BodiesGiven, BodiesWanted } from "./bodies.ts";
import { engine, makersAgain } from "./engine.ts";
import { loadRequestOf, type KnownMilling, type KnownOutcome, type LoadRequest } from "./load-request.ts";
import type { Outcome, Planned, Stage } from "./outcome.ts";
import type { PlayedCourse, PlayedOn, StockPictures } from "./played.ts";
import { provedBeside, type Proved } from "./proved.ts";
import type { reported } from "./reported.ts";
import type { Request } from "./request.ts";
import { wireOutcomes } from "./wire.ts";

z.config({ jitless: true });
wireOutcomes();

// Held as long as this worker lives, under its name: so the page learns when it has ended.
void navigator.locks?.request(self.name, () => new Promise<void>(() => undefined));

/** The open work changes bit by bit; what stands beside it, of no version, is another one each time. */
const openWork = makersAgain();

/** The newest outcome of the open work: what is asked about it later need not be sent here again. */
let newest: Outcome | null = null;
const knownRequest = ({ version, moves }: KnownOutcome): LoadRequest | null =>
  newest?.version === version && newest.run.steps.length === moves ? loadRequestOf(newest) : null;
const requestOf = (of: KnownOutcome | LoadRequest) => ("moves" in of ? knownRequest(of) : of);

/** The run that was sent last, before its proof: it is not made twice. */
let ahead: Planned | null = null;
const makersOf = ({ version }: Request): typeof openWork => {
  const made = ahead?.version === version ? ahead : null;
  return made ? { ...openWork, planned: () => made } : openWork;
};

/** The result with what its run took. */
function updated(request: Request, tell: (stage: Stage) => void = () => undefined): Outcome {
  const begun = stopwatch();
  let pace = 0;
  const outcome = engine.update(
    request,
    (stage) => {
      if (stage === "proving") pace = stopwatch() - begun;
      tell(stage);
    },
    request.version > 0 ? makersOf(request) : undefined,
  );
  if (outcome.version > 0) newest = outcome;
  return { ...outcome, pace };
}

/** The run of a request, of which `proved` then sends the proof. */
function planned(request: Request, tell?: (stage: Stage) => void): Planned {
  const begun = stopwatch();
  ahead = openWork.planned(request, tell);
  return { ...ahead, pace: stopwatch() - begun };
}

/**
 * The proof of a request whose run the page has, without the marks that it has as well when `has` is the version of the
 * last answer.
 */
function proved(request: Request, has: number | null, tell?: (stage: Stage) => void): Proved {
  const before = newest?.version === has ? newest : null;
  return provedBeside(updated(request, tell).simulation, before?.simulation.checkpoints ?? []);
}

type Advice = typeof advice;
const fetchAdvice = async (): Promise<Advice> => (await import("./advice.ts")).advice;

const fetchPlayed = () => import("./played.ts");
const fetchMilling = () => import("./played-milling.ts");

const knownMilling = ({ version, motions }: KnownMilling): Outcome | null =>
  newest?.version === version && newest.run.plane.length === motions ? newest : null;

/** What the page can ask: what every work needs is there at once, advice is fetched when it is first asked for. */
const served = {
  ...engine,
  update: updated,
  planned,
  proved,
  knows: (known: KnownOutcome) => knownRequest(known) !== null,
  pathLoad: async (of: KnownOutcome | LoadRequest) => {
    const request = requestOf(of);
    return request && (await import("./load.ts")).pathLoad(request);
  },
  roughness: async (of: KnownOutcome | LoadRequest) => {
    const request = requestOf(of);
    return request && (await import("./load.ts")).roughness(request);
  },
  /** Paints the stock of the newest outcome while it plays; false when it cannot. */
  async play(of: KnownOutcome, on: PlayedOn, look: StockLook, course: PlayedCourse): Promise<boolean> {
    const outcome = newest;
    if (!outcome || !knownRequest(of)) return false;
    return await (await fetchPlayed()).play(outcome, on, look, course);
  },
  /** Paints the newest outcome as it stands; null when it is not the one that is asked for. */
  async stockPictures(of: KnownOutcome, look: StockLook, position: PlayPosition): Promise<StockPictures | null> {
    const outcome = newest;
    if (!outcome || !knownRequest(of)) return null;
    const made = (await fetchPlayed()).stockPictures(outcome, look, position);
    return transfer(made, [made.work, made.shop]);
  },
  /** The turned bodies of the newest outcome at a moment; null when it is not the one that is asked for. */
  async bodies(of: KnownOutcome, wanted: BodiesWanted): Promise<BodiesGiven | null> {
    const { turnedBodies, buffersOf } = await import("./bodies.ts"),
      outcome = newest;
    if (!outcome || !knownRequest(of)) return null;
    const made = turnedBodies(outcome, wanted);
    return made === "same" ? made : transfer(made, buffersOf(made));
  },
  /** Paints what is milled of the newest outcome while it plays; false when it cannot. */
  async playMilling(of: KnownMilling, on: PlayedOn, look: MilledLook, course: PlayedCourse): Promise<boolean> {
    const outcome = knownMilling(of);
    return outcome !== null && (await (await fetchMilling()).playMilling(outcome, on, look, course));
  },
  /** Paints what is milled of the newest outcome as it stands; null when it is not the one that is asked for. */
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
  reported: async (...asked: Parameters<typeof reported>) => (await import("./reported.ts")).reported(...asked),
};
expose(served);

export type Engine = typeof served;
