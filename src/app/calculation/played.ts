import type { PlayPosition } from "../../sim/simulation.ts";
import { playerOf, sameBlank } from "../../sim/stock.ts";
import type { Patch } from "../../view/material/pen.ts";
import {
  paintSurroundings,
  stockPainter,
  type PaintedRun,
  type StockLook,
  type StockPainter,
} from "../../view/material/stock-painter.ts";
import { positionAt, trackOf, type PlayedTrack } from "../../view/playback.ts";
import { dayMoment, stopwatch } from "../base/clock.ts";
import { onlyNewest } from "../base/once.ts";
import { surfacesOfRun } from "./moving.ts";
import type { Outcome } from "./outcome.ts";

/**
 * The course of a playback: `seconds` of machine time at the time `since` (ms since 1970), and `rate` machine seconds
 * per second.
 */
export interface PlayedCourse {
  readonly seconds: number;
  readonly since: number;
  readonly rate: number;
}

/** The canvas of a playback, by its name; the canvas itself is sent the first time. */
export interface PlaybackCanvas {
  readonly name: string;
  readonly canvas: OffscreenCanvas | null;
}

interface Playable {
  readonly run: PaintedRun;
  readonly track: PlayedTrack;
}
const playables = new WeakMap<Outcome, Playable>();

function playableOf(outcome: Outcome): Playable {
  const known = playables.get(outcome);
  if (known) return known;
  const {
    run: { steps },
    simulation,
  } = outcome;
  const run: PaintedRun = {
    steps,
    stockAt: playerOf(simulation).at,
    isSameBlank: sameBlank(simulation),
    surfaces: surfacesOfRun(outcome.run),
  };
  const made = { run, track: trackOf(steps) };
  playables.set(outcome, made);
  return made;
}

/** Pictures of the stock and of what is around it, for another look. */
export interface StockPictures {
  readonly work: ImageBitmap;
  readonly shop: ImageBitmap;
}

const sized = ({ width, height }: Patch, ratio: number) =>
  [Math.round(width * ratio), Math.round(height * ratio)] as const;

/** Paints a part of a picture on its own canvas. */
export function painted(
  part: Patch,
  ratio: number,
  paint: (pen: OffscreenCanvasRenderingContext2D) => void,
): ImageBitmap {
  const canvas = new OffscreenCanvas(...sized(part, ratio)),
    pen = canvas.getContext("2d");
  if (pen) paint(pen);
  return canvas.transferToImageBitmap();
}

/** Paints a result at a position. */
export function stockPictures(outcome: Outcome, look: StockLook, position: PlayPosition): StockPictures {
  const painter = stockPainter(playableOf(outcome).run);
  painter.goTo(position);
  return {
    work: painted(look.origin, look.ratio, (pen) => painter.paintAll(pen, look)),
    shop: painted(look.ground, look.ratio, (pen) => paintSurroundings(pen, look)),
  };
}

/** A larger canvas is painted every second frame only, since the browser composites all of it again, pixels. */
const MOST_EACH = 2_000_000;

/** The canvas that was transferred last, by its name. */
const canvases = new Map<string, OffscreenCanvas>();
/** A playback ends when the next one begins. */
const begin = onlyNewest();

/** Stops painting. */
export const stopPlaying = (): void => void begin();

const picture = (): Promise<number> => new Promise((done) => requestAnimationFrame(done));

/** What is painted during playback. */
interface Played<Look> {
  readonly painter: Pick<StockPainter, "goTo"> & {
    readonly paintAll: (pen: OffscreenCanvasRenderingContext2D, look: Look) => void;
    readonly paintChanges: (pen: OffscreenCanvasRenderingContext2D, look: Look, position: PlayPosition) => boolean;
  };
  readonly track: PlayedTrack;
}

/**
 * Paints frame after frame until another playback begins or painting is stopped. Resolves after the first frame; false
 * if the canvas is unknown. `until` waits until a step can be painted.
 */
export async function playPainted<Look extends Pick<StockLook, "origin" | "ratio">>(
  { painter, track }: Played<Look>,
  on: PlaybackCanvas,
  look: Look,
  course: PlayedCourse,
  until: (step: number) => Promise<boolean> = () => Promise.resolve(true),
): Promise<boolean> {
  const isNewest = begin();
  if (on.canvas) {
    canvases.clear();
    canvases.set(on.name, on.canvas);
  }
  const pen = ("requestAnimationFrame" in self && canvases.get(on.name)?.getContext("2d")) || null;
  if (!pen) return false;
  const { canvas } = pen;
  const [width, height] = sized(look.origin, look.ratio);
  if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
  const at = (now: number) =>
    positionAt(track, course.seconds + (course.rate * (dayMoment(now) - course.since)) / 1000);
  if (!(await until(at(stopwatch()).step)) || !isNewest()) return false;
  painter.goTo(at(stopwatch()));
  painter.paintAll(pen, look);
  await picture();
  void (async () => {
    while (isNewest()) {
      if (width * height > MOST_EACH) await picture();
      painter.paintChanges(pen, look, at(await picture()));
    }
  })();
  await picture();
  return isNewest();
}

/** The same for the turned stock of a result. */
export function play(outcome: Outcome, on: PlaybackCanvas, look: StockLook, course: PlayedCourse): Promise<boolean> {
  const { run, track } = playableOf(outcome);
  return playPainted({ painter: stockPainter(run), track }, on, look, course);
}
