import type { MachineSide } from "../../../program/run/plane-index.ts";
import type { PlayPosition } from "../../../sim/simulation.ts";
import type { Camera } from "../../../view/camera.ts";
import type { PaintedLook, Painter } from "../../../view/material/painter.ts";
import type { Patch } from "../../../view/material/pen.ts";
import { groundPicture } from "../../calculation/bitmap.ts";
import type { KnownSide } from "../../calculation/load-request.ts";
import type { Looks, StockPictures } from "../../calculation/played.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { askWorker } from "../../calculation/worker-life.ts";
import { fitCanvas } from "./fit-canvas.ts";
import { playedLayer } from "./played-layer.ts";
import { drawnRoom, type Viewport } from "./viewport.ts";
import { shiftSheet } from "./World.tsx";

/** The origin of a sheet without work. */
export const NOWHERE: Patch = { x: 0, y: 0, width: 0, height: 0 };

/** Time for the worker to repaint before the page does it, ms; meanwhile the old picture is shifted. */
const PATIENCE = 150;

const isSamePlace = (a: PlayPosition, b: PlayPosition) => a.step === b.step && a.fraction === b.fraction;

/** The worker's picture for a view; null if it has none, or not in time. */
async function stockPictures<Side extends MachineSide>(
  of: KnownSide<Side>,
  look: Looks[Side],
  position: PlayPosition,
): Promise<StockPictures | null> {
  const late = new Promise<null>((done) => setTimeout(() => done(null), PATIENCE));
  try {
    return await Promise.race([askWorker((engine) => engine.stockPictures(of, look, position)), late]);
  } catch {
    return null;
  }
}

/**
 * The canvases of a sheet from back to front: surroundings of the workpiece, workpiece painted by the page, workpiece
 * painted by the worker.
 */
export interface SheetCanvases {
  readonly under: HTMLCanvasElement;
  readonly over: HTMLCanvasElement;
  readonly given: HTMLCanvasElement;
  /** Container of the worker's own layer, which covers them during playback. */
  readonly holder: HTMLElement;
}

/** What a look is made for: the drawn camera, its resolution, and the drawn part of the picture. */
export interface SheetView {
  readonly camera: Camera;
  readonly ratio: number;
  readonly room: Patch;
}

/** Content of a sheet. */
export interface PaintedScene<Side extends MachineSide = MachineSide> {
  readonly viewport: Viewport;
  /** Null before anything moves. */
  readonly playback: PlaybackStore | null;
  readonly painter: Painter<Looks[Side]>;
  readonly look: (view: SheetView) => Looks[Side];
  /** Settings and colours: a picture of another style is repainted by the page at once. */
  readonly style: string;
  /** The shown work, if the worker has it. */
  readonly known: () => KnownSide<Side> | null;
  /** Stock that is cut bit by bit: how far, and who hears of it; null if all of it is known. */
  readonly growing: {
    readonly reached: () => number;
    readonly subscribe: (listener: () => void) => () => void;
  } | null;
}

/** What the canvases show, kept between scenes, so that only changes are repainted. */
export interface SheetMemory {
  ground: string;
  work: readonly unknown[];
  /** The view that they were painted for, and its style; null before the first picture. */
  laid: (PaintedLook & { readonly style: string }) | null;
}

/**
 * Paints a scene and follows its camera and playback; returns the function that stops it. If only the stock differs
 * from the previous scene, the worker, which has that stock, paints it, and the page shows it once ready.
 */
export function followSheet<Side extends MachineSide>(
  { under, over, given, holder }: SheetCanvases,
  { viewport, playback, painter, look: lookOf, style, known, growing }: PaintedScene<Side>,
  memory: SheetMemory,
): () => void {
  const shop = under.getContext("bitmaprenderer"),
    pen = over.getContext("2d"),
    frame = given.getContext("bitmaprenderer");
  if (!shop || !pen || !frame) return () => undefined;
  const played = playback && playedLayer(holder, playback, known);
  const nextLook = () =>
    lookOf({ camera: viewport.drawn(), ratio: viewport.ratio(), room: drawnRoom(viewport.size()) });
  let look = nextLook(),
    laid: PaintedLook = memory.laid ?? look;
  /** True while the canvases show the previous scene. */
  let isOld = true;
  /** The camera the worker is painting for. */
  let awaited: Camera | null = null;
  /** Whether the stock was cut up to the painted moment. */
  let isCut = false;
  const reaches = () => !growing || !playback || growing.reached() >= playback.shown().step;
  /** Switches to the view that the picture is drawn for; later painting uses it. */
  const turn = () => {
    laid = look = nextLook();
    memory.laid = { ...look, style };
    isOld = false;
    isCut = reaches();
  };
  const shift = () => {
    if (laid.ground) shiftSheet(under, viewport, laid.ground, laid.camera);
    for (const sheet of [over, given, played?.canvas()])
      if (sheet) shiftSheet(sheet, viewport, laid.origin, laid.camera);
  };
  let shows: "own" | "given" | "played" = given.style.visibility === "" ? "given" : "own";
  const show = (which: typeof shows) => {
    shows = which;
    over.style.visibility = which === "own" ? "" : "hidden";
    given.style.visibility = which === "given" ? "" : "hidden";
  };
  /** Copies the worker's picture before painting on it. */
  const own = () => {
    if (shows === "own") return;
    if (shows === "given") {
      fitCanvas(over, laid.origin, laid.ratio);
      pen.setTransform(1, 0, 0, 1, 0, 0);
      // A canvas of the same size still has the picture before that.
      pen.clearRect(0, 0, over.width, over.height);
      pen.drawImage(given, 0, 0);
    }
    show("own");
  };
  const viewKey = () => JSON.stringify([style, look.camera, look.ratio, look.origin]);
  const groundKey = () => JSON.stringify([viewKey(), look.ground, drawnRoom(viewport.size())]);
  // A planned path keeps the previous stock, so no step of it needs painting.
  const workKey = () => [...painter.parts(), viewKey()];
  const layGround = (picture: ImageBitmap | null) => {
    memory.ground = groundKey();
    if (!look.ground || !picture) return;
    fitCanvas(under, look.ground, look.ratio);
    shop.transferFromImageBitmap(picture);
  };
  const paintAll = () => {
    awaited = null;
    played?.stop();
    if (playback) painter.goTo(playback.shown());
    turn();
    if (groundKey() !== memory.ground) layGround(groundPicture(painter, look));
    if (shows === "played") show("own");
    const looks = workKey();
    if (looks.every((each, i) => each === memory.work[i])) return;
    memory.work = looks;
    show("own");
    fitCanvas(over, look.origin, look.ratio);
    painter.all(pen, look);
  };
  /** Shows the worker's picture. */
  const take = ({ work, shop: around }: StockPictures, position: PlayPosition) => {
    awaited = null;
    played?.stop();
    painter.goTo(position);
    turn();
    layGround(around);
    memory.work = workKey();
    fitCanvas(given, look.origin, look.ratio);
    frame.transferFromImageBitmap(work);
    show("given");
    if (playback?.shown() !== position) paintMoved();
  };
  /** Has the workpiece painted for the present view; until then the old picture is shifted. */
  const repaintForCamera = async (of: KnownSide<Side>, position: PlayPosition) => {
    const next = nextLook();
    awaited = next.camera;
    const made = await stockPictures(of, next, position);
    if (awaited !== next.camera) return;
    if (made) take(made, position);
    else paintAll();
    shift();
  };
  /** After a change of the program the previous stock stays until the new one is cut as far. */
  const keepsOld = () => memory.laid?.style === style && !reaches();
  const follow = () => {
    const now = viewport.drawn(),
      of = playback?.flows && now.xUp === laid.camera.xUp ? known() : null;
    if (now === laid.camera && (!isOld || keepsOld())) awaited = null;
    else if (!of || !playback || (isOld && (playback.get().playing || memory.laid?.style !== style))) paintAll();
    else if (now !== awaited) void repaintForCamera(of, playback.shown());
    shift();
  };
  let waits = false;
  const paintMoved = () => {
    if (!playback) return;
    // The worker's picture is ready soon, and then follows to the current position.
    if (isOld && awaited && !playback.get().playing) return;
    if (isOld) paintAll();
    if (played?.follow(() => look)) {
      if (shows === "given") own();
      return show("played");
    }
    // The eye follows the tool, so during playback the material may follow every second frame.
    waits = !waits && playback.get().playing;
    if (waits || (shows !== "played" && isSamePlace(painter.at(), playback.shown()))) return;
    own();
    if (painter.follow(pen, look, playback.shown())) memory.work = [];
    isCut = reaches();
  };
  const paintGrown = () => {
    if (shows === "played" || isCut || !reaches()) return;
    paintAll();
    shift();
  };
  show(shows);
  follow();
  const ends = [
    viewport.subscribe(follow),
    playback?.subscribe(paintMoved),
    growing?.subscribe(paintGrown),
    played?.stop,
  ];
  return () => {
    awaited = null;
    // The page's own canvas is behind the playback: the next scene repaints it at once.
    if (shows === "played") {
      memory.laid = null;
      show("own");
    }
    ends.forEach((end) => end?.());
  };
}
