import type { PlayPosition } from "../../sim/simulation.ts";
import type { MilledLook } from "../../view/approach/milled-painter.ts";
import type { PaintedLook, Painter } from "../../view/material/painter.ts";
import type { StockLook } from "../../view/material/stock-painter.ts";
import { positionAt, type PlayedTrack } from "../../view/playback.ts";
import { dayMoment, stopwatch } from "../base/clock.ts";
import { onlyNewest } from "../base/once.ts";
import { groundPicture, painted, sized } from "./bitmap.ts";

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

/** A result whose stock can be painted on a playback. */
export interface Playable<Look extends PaintedLook> {
  /** A painter at the start. */
  readonly painter: () => Painter<Look>;
  readonly track: PlayedTrack;
  /** Waits until a step can be painted; false if another result is requested first. */
  readonly reaches: (step: number) => Promise<boolean>;
}

/** The views of a stock, by the picture that shows it. */
export interface Looks {
  readonly lathe: StockLook;
  readonly plane: MilledLook;
}

/** Pictures of the stock and of what is around it, for another look. */
export interface StockPictures {
  readonly work: ImageBitmap;
  /** Null for a look without surroundings. */
  readonly shop: ImageBitmap | null;
}

/** Paints a result at a position; null if another one is requested meanwhile. */
export async function stockPictures<Look extends PaintedLook>(
  { painter: begun, reaches }: Playable<Look>,
  look: Look,
  position: PlayPosition,
): Promise<StockPictures | null> {
  if (!(await reaches(position.step))) return null;
  const painter = begun();
  painter.goTo(position);
  return {
    work: painted(look.origin, look.ratio, (pen) => painter.all(pen, look)),
    shop: groundPicture(painter, look),
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

/**
 * Paints a result frame after frame until another playback begins or painting is stopped. Resolves after the first
 * frame; false if it cannot be painted.
 */
export async function play<Look extends PaintedLook>(
  { painter: begun, track, reaches }: Playable<Look>,
  on: PlaybackCanvas,
  look: Look,
  course: PlayedCourse,
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
  if (!(await reaches(at(stopwatch()).step)) || !isNewest()) return false;
  const painter = begun();
  painter.goTo(at(stopwatch()));
  painter.all(pen, look);
  await picture();
  void (async () => {
    while (isNewest()) {
      if (width * height > MOST_EACH) await picture();
      painter.follow(pen, look, at(await picture()));
    }
  })();
  await picture();
  return isNewest();
}
