import { transfer, type Remote } from "comlink";
import type { Step } from "../../../kernel/time/step.ts";
import type { StockLook } from "../../../view/material/stock-painter.ts";
import { secondsAt, type PlayedTrack } from "../../../view/playback.ts";
import { dayMoment } from "../../base/clock.ts";
import type { KnownOutcome } from "../../calculation/load-request.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import type { PlayedCourse, PlaybackCanvas } from "../../calculation/played.ts";
import type { Engine } from "../../calculation/worker.ts";
import { askWorker } from "../../calculation/worker-life.ts";
import { counter } from "../../base/once.ts";
import { layOver } from "./fit-canvas.ts";
import { isOnCourse, type PlayCourse } from "../../calculation/glide.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";

/** The stock painted by the worker during playback, on its own layer over that of the page. */
export interface PlayedLayer<Look> {
  /** Follows the playback; true while the layer shows the stock, so that the page need not paint it. */
  readonly follow: (look: () => Look) => boolean;
  /** Hides the layer until it follows again. */
  readonly stop: () => void;
  readonly canvas: () => HTMLCanvasElement | null;
}

/** A canvas whose content belongs to the worker, and its name there. */
interface Layer {
  readonly canvas: HTMLCanvasElement;
  readonly name: string;
  sent: boolean;
}

const layers = new WeakMap<HTMLElement, Layer>();
const nextNumber = counter();

function layerIn(holder: HTMLElement): Layer {
  const known = layers.get(holder);
  if (known) return known;
  const canvas = document.createElement("canvas");
  canvas.className = "sheet material";
  canvas.style.visibility = "hidden";
  holder.append(canvas);
  const made = { canvas, name: `played ${nextNumber()}`, sent: false };
  layers.set(holder, made);
  return made;
}

/** Leaves stock that the worker does not know, or cannot paint, to the page. */
function drop(holder: HTMLElement): void {
  layers.get(holder)?.canvas.remove();
  layers.delete(holder);
}

const canPaint = () =>
  typeof HTMLCanvasElement !== "undefined" && "transferControlToOffscreen" in HTMLCanvasElement.prototype;

/** The version of the open work, if its steps are being played: the worker has that work. */
export function knownOf(steps: readonly Step[]): KnownOutcome | null {
  const { shown } = useOutcome.getState();
  return shown?.run.steps === steps ? { version: shown.version, moves: steps.length } : null;
}

/** Asks the worker to paint the playback for a view. */
export type PlayedByWorker<Look> = (
  engine: Remote<Engine>,
  on: PlaybackCanvas,
  look: Look,
  course: PlayedCourse,
) => Promise<boolean>;

async function ask<Look>(layer: Layer, play: PlayedByWorker<Look>, look: Look, course: PlayCourse): Promise<boolean> {
  const canvas = layer.sent ? null : layer.canvas.transferControlToOffscreen();
  layer.sent = true;
  const on = canvas ? transfer({ name: layer.name, canvas }, [canvas]) : { name: layer.name, canvas };
  const { from: seconds, rate } = course,
    since = dayMoment(course.since);
  try {
    return await askWorker((engine) => play(engine, on, look, { seconds, since, rate }));
  } catch {
    return false;
  }
}

/** How the worker plays the turning steps of the open work; null if it does not know them. */
export function playedSteps(steps: readonly Step[]): PlayedByWorker<StockLook> | null {
  const of = knownOf(steps);
  return of && ((engine, ...asked) => engine.play(of, ...asked));
}

/** A layer in an element that follows a playback known to the worker. */
export function playedLayer<Look extends Pick<StockLook, "origin">>(
  holder: HTMLElement,
  playback: PlaybackStore,
  known: () => PlayedByWorker<Look> | null,
): PlayedLayer<Look> {
  let course: PlayCourse | null = null,
    state: "asked" | "shown" | "refused" = "asked",
    begun = 0;
  const stop = () => {
    if (!course) return;
    course = null;
    begun += 1;
    const layer = layers.get(holder);
    if (layer) layer.canvas.style.visibility = "hidden";
    if (layer && state !== "refused") void askWorker((engine) => engine.stopPlaying()).catch(() => undefined);
  };
  const begin = async (play: PlayedByWorker<Look>, look: Look, next: PlayCourse) => {
    if (state !== "shown" || !course) state = "asked";
    course = next;
    begun += 1;
    const own = begun,
      layer = layerIn(holder);
    layOver(layer.canvas, look.origin);
    const isShown = await ask(layer, play, look, next);
    if (own !== begun) return;
    state = isShown ? "shown" : "refused";
    if (isShown) layer.canvas.style.visibility = "";
    else drop(holder);
  };
  return {
    stop,
    canvas: () => layers.get(holder)?.canvas ?? null,
    follow(look) {
      const now = playback.get(),
        since = playback.since(),
        play = since === null || !canPaint() ? null : known();
      if (!play || since === null) {
        stop();
        return false;
      }
      if (!course || (state !== "refused" && !isOnCourse(course, now, since))) {
        const track: PlayedTrack = now.track;
        void begin(play, look(), { track, rate: now.rate, from: secondsAt(track, now.position), since });
      }
      return state === "shown";
    },
  };
}
