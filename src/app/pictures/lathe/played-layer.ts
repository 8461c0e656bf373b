import { transfer } from "comlink";
import type { Step } from "../../../kernel/time/step.ts";
import { motionsOf, type MachineSide } from "../../../program/run/plane-index.ts";
import type { PlaneStep } from "../../../program/tools/plane-types.ts";
import { secondsAt, type PlayedTrack } from "../../../view/playback.ts";
import { dayMoment } from "../../base/clock.ts";
import type { KnownSide } from "../../calculation/load-request.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import type { Looks } from "../../calculation/played.ts";
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

/** The version of the open work, if it is the one with these motions: the worker has that work. */
export function knownOf<Side extends MachineSide>(
  motions: readonly Step[] | readonly PlaneStep[],
  side: Side,
): KnownSide<Side> | null {
  const { shown } = useOutcome.getState();
  return shown && motionsOf(shown.run, side) === motions
    ? { side, version: shown.version, moves: motions.length }
    : null;
}

async function ask<Side extends MachineSide>(
  layer: Layer,
  of: KnownSide<Side>,
  look: Looks[Side],
  course: PlayCourse,
): Promise<boolean> {
  const canvas = layer.sent ? null : layer.canvas.transferControlToOffscreen();
  layer.sent = true;
  const on = canvas ? transfer({ name: layer.name, canvas }, [canvas]) : { name: layer.name, canvas };
  const { from: seconds, rate } = course,
    since = dayMoment(course.since);
  try {
    return await askWorker((engine) => engine.play(of, on, look, { seconds, since, rate }));
  } catch {
    return false;
  }
}

/** A layer in an element that follows a playback known to the worker. */
export function playedLayer<Side extends MachineSide>(
  holder: HTMLElement,
  playback: PlaybackStore,
  known: () => KnownSide<Side> | null,
): PlayedLayer<Looks[Side]> {
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
  const begin = async (of: KnownSide<Side>, look: Looks[Side], next: PlayCourse) => {
    if (state !== "shown" || !course) state = "asked";
    course = next;
    begun += 1;
    const own = begun,
      layer = layerIn(holder);
    layOver(layer.canvas, look.origin);
    const isShown = await ask(layer, of, look, next);
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
        of = since === null || !canPaint() ? null : known();
      if (!of || since === null) {
        stop();
        return false;
      }
      if (!course || (state !== "refused" && !isOnCourse(course, now, since))) {
        const track: PlayedTrack = now.track;
        void begin(of, look(), { track, rate: now.rate, from: secondsAt(track, now.position), since });
      }
      return state === "shown";
    },
  };
}
