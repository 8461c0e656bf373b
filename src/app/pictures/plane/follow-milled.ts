import type { PlaneStep } from "../../../program/tools/plane-types.ts";
import type { PlayPosition } from "../../../sim/simulation.ts";
import type { Camera } from "../../../view/camera.ts";
import { toneOfDepth, type MilledColours } from "../../../view/approach/milled-paint.ts";
import { milledPainter, type MilledLook } from "../../../view/approach/milled-painter.ts";
import type { Patch } from "../../../view/material/pen.ts";
import { patchOf, patchWithin } from "../../../view/material/changed-box.ts";
import type { KnownMilling } from "../../calculation/load-request.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import { askWorker } from "../../calculation/worker-life.ts";
import { fitCanvas } from "../lathe/fit-canvas.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { playedLayer } from "../lathe/played-layer.ts";
import { pageColours } from "../../base/use-theme-colours.ts";
import { drawnRoom, type Viewport } from "../lathe/viewport.ts";
import { shiftSheet } from "../lathe/World.tsx";
import type { GrowingStock } from "./milled.ts";

const COLOURS = {
  ground: "--material",
  edge: "--line-strong",
  step: "--line-strong",
} as const satisfies Record<keyof MilledColours, string>;

const NOWHERE: Patch = { x: 0, y: 0, width: 0, height: 0 };

/** Time for the worker to repaint before the page does it, ms; meanwhile the old picture is shifted. */
const PATIENCE = 150;

/** The CSS property of the tone of a depth. */
export const toneName = (depth: number, depths: number): string => `--milled-${toneOfDepth(depth, depths) + 1}`;

/**
 * The canvases of a sheet: painted by the page, painted by the worker, and the container of the worker's own layer over
 * them.
 */
export interface MilledCanvases {
  readonly over: HTMLCanvasElement;
  readonly given: HTMLCanvasElement;
  readonly holder: HTMLElement;
}

/** Content of a sheet. */
export interface MilledScene {
  readonly viewport: Viewport;
  readonly steps: readonly PlaneStep[];
  readonly playback: PlaybackStore;
  readonly milled: GrowingStock;
}

/** What the canvases show, kept between scenes. */
export interface MilledMemory {
  /** Camera, resolution and origin of the painted picture; null once that is outdated. */
  painted: { readonly camera: Camera; readonly ratio: number; readonly origin: Patch } | null;
}

/** The version of the open work, if its milling is shown: the worker has that work. */
function knownOf(steps: readonly PlaneStep[]): KnownMilling | null {
  const { shown } = useOutcome.getState();
  return shown?.run.plane === steps ? { version: shown.version, motions: steps.length } : null;
}

/** The worker's picture for a view; null if it has none, or not in time. */
async function milledPicture(of: KnownMilling, look: MilledLook, position: PlayPosition): Promise<ImageBitmap | null> {
  const late = new Promise<null>((done) => setTimeout(() => done(null), PATIENCE));
  try {
    return await Promise.race([askWorker((engine) => engine.milledPicture(of, look, position)), late]);
  } catch {
    return null;
  }
}

/** Paints milled stock and follows its camera and playback; returns the function that stops it. */
export function followMilled(
  { over, given, holder }: MilledCanvases,
  scene: MilledScene,
  memory: MilledMemory,
): () => void {
  const {
    viewport,
    steps,
    playback,
    milled: { stock, blank, subscribe },
  } = scene;
  const pen = over.getContext("2d"),
    frame = given.getContext("bitmaprenderer");
  if (!pen || !frame) return () => undefined;
  const names = Array.from({ length: stock.limits.length - 1 }, (_, i) => toneName(i, stock.limits.length - 1));
  const named = pageColours(Object.fromEntries(names.map((name) => [name, name])));
  const colours = pageColours(COLOURS),
    tones = names.map((name) => named[name] ?? "");
  const painter = milledPainter(steps, stock);
  const played = playedLayer<MilledLook>(holder, playback, () => {
    const of = knownOf(steps);
    return of && ((engine, ...asked) => engine.playMilling(of, ...asked));
  });
  let { camera, origin, ratio } = memory.painted ?? {
    camera: viewport.drawn(),
    origin: NOWHERE,
    ratio: viewport.ratio(),
  };
  let shows: "own" | "given" | "played" = given.style.visibility === "" ? "given" : "own";
  /** The camera the worker is painting for, and the progress of the painted stock. */
  let awaited: Camera | null = null,
    reached = 0;
  const look = (): MilledLook => ({ camera, colours, tones, ratio, origin });
  const nextLook = (): MilledLook => {
    const next = viewport.drawn(),
      room = drawnRoom(viewport.size()),
      dots = viewport.ratio();
    return {
      ...look(),
      camera: next,
      ratio: dots,
      origin: (blank && patchWithin(patchOf(blank, next, dots), room)) ?? NOWHERE,
    };
  };
  const turn = () => {
    ({ camera, ratio, origin } = nextLook());
    memory.painted = { camera, origin, ratio };
    reached = stock.reached();
  };
  const shift = () => {
    for (const sheet of [over, given, played.canvas()]) if (sheet) shiftSheet(sheet, viewport, origin, camera);
  };
  const show = (which: typeof shows) => {
    shows = which;
    over.style.visibility = which === "own" ? "" : "hidden";
    given.style.visibility = which === "given" ? "" : "hidden";
  };
  /** Copies the worker's picture before painting on it. */
  const own = () => {
    if (shows === "given") {
      fitCanvas(over, origin, ratio);
      pen.setTransform(1, 0, 0, 1, 0, 0);
      pen.drawImage(given, 0, 0);
      shift();
    }
    show("own");
  };
  const paintAll = () => {
    awaited = null;
    played.stop();
    painter.goTo(playback.shown());
    turn();
    fitCanvas(over, origin, ratio);
    painter.paintAll(pen, look());
    show("own");
    shift();
  };
  /** Shows the worker's picture. */
  const take = (picture: ImageBitmap, position: PlayPosition) => {
    awaited = null;
    played.stop();
    painter.goTo(position);
    turn();
    fitCanvas(given, origin, ratio);
    frame.transferFromImageBitmap(picture);
    show("given");
    shift();
    if (playback.shown() !== position) paintMoved();
  };
  /** Has the stock painted for the present view; until then the old picture is shifted. */
  const repaintForCamera = async (of: KnownMilling, position: PlayPosition) => {
    const next = nextLook();
    awaited = next.camera;
    const made = await milledPicture(of, next, position);
    if (awaited !== next.camera) return;
    if (made) take(made, position);
    else paintAll();
  };
  const follow = () => {
    const of = playback.flows ? knownOf(steps) : null,
      now = viewport.drawn();
    if (now === camera) awaited = null;
    else if (!of) paintAll();
    else if (now !== awaited) void repaintForCamera(of, playback.shown());
    shift();
  };
  let waits = false;
  const paintMoved = () => {
    if (played.follow(look)) {
      own();
      return show("played");
    }
    const { step, fraction } = painter.at(),
      at = playback.shown();
    waits = !waits && playback.get().playing;
    if (waits || (shows !== "played" && step === at.step && fraction === at.fraction)) return;
    own();
    painter.paintChanges(pen, look(), at);
    reached = stock.reached();
  };
  const paintGrown = () => {
    const { step } = playback.shown();
    if (shows === "played" || reached >= step) return;
    if (memory.painted && stock.reached() < step) return;
    paintAll();
  };
  painter.goTo(playback.shown());
  // After a change of the program the previous stock stays until the new one is cut as far.
  if (memory.painted && stock.reached() < playback.shown().step) show(shows);
  else paintAll();
  follow();
  const ends = [viewport.subscribe(follow), playback.subscribe(paintMoved), subscribe(paintGrown), played.stop];
  return () => {
    awaited = null;
    if (shows === "played") {
      memory.painted = null;
      show("own");
    }
    ends.forEach((end) => end());
  };
}
