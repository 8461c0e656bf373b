import type { Ring } from "../../../kernel/geometry/point.ts";
import type { PlayPosition } from "../../../sim/simulation.ts";
import { boundsOf } from "../../../view/bounds.ts";
import type { Camera } from "../../../view/camera.ts";
import type { ChuckDrawing } from "../../../view/material/chuck.ts";
import type { Patch } from "../../../view/material/pen.ts";
import type { MaterialColours } from "../../../view/material/paint-target.ts";
import {
  farthest,
  paintSurroundings,
  stockPainter,
  untouchedRun,
  type StockLook,
} from "../../../view/material/stock-painter.ts";
import { chuckPatch, patchWithin, turnedPatchOf } from "../../../view/material/changed-box.ts";
import type { KnownOutcome } from "../../calculation/load-request.ts";
import type { StockPictures } from "../../calculation/played.ts";
import { askWorker } from "../../calculation/worker-life.ts";
import type { SectionView } from "../../base/settings/settings.ts";
import { fitCanvas } from "./fit-canvas.ts";
import type { PlayedScene } from "../../calculation/moving.ts";
import { knownOf, playedLayer, playedSteps } from "./played-layer.ts";
import { pageColours } from "../../base/use-theme-colours.ts";
import { drawnRoom, type Viewport } from "./viewport.ts";
import { shiftSheet } from "./World.tsx";

const COLOURS = {
  ground: "--material",
  hatch: "--material-hatch",
  edge: "--steel-edge",
  steelDark: "--steel-dark",
  steel: "--steel",
  steelLight: "--steel-light",
  chuckDark: "--chuck-dark",
  chuck: "--chuck",
  chuckLight: "--chuck-light",
} as const satisfies Record<keyof MaterialColours, string>;

const NOWHERE: Patch = { x: 0, y: 0, width: 0, height: 0 };
/** Used if nothing is around the workpiece, since a bitmap has at least one pixel. */
const SPECK: Patch = { x: 0, y: 0, width: 1, height: 1 };

/** Time for the worker to repaint before the page does it, ms; meanwhile the old picture is shifted. */
const PATIENCE = 150;

const isSamePlace = (a: PlayPosition, b: PlayPosition) => a.step === b.step && a.fraction === b.fraction;

/** The worker's picture for a view; null if it has none, or not in time. */
async function stockPictures(of: KnownOutcome, look: StockLook, position: PlayPosition): Promise<StockPictures | null> {
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

/** Content of a sheet. */
export interface SheetScene {
  readonly viewport: Viewport;
  readonly moving: PlayedScene | null;
  /** The blank before anything moves. */
  readonly blank: readonly Ring[];
  readonly section: SectionView;
  readonly chuck: ChuckDrawing | null;
  readonly theme: number;
}

/** What the canvases were painted for: the view, and the parts of the picture they cover. */
type Laid = Pick<StockLook, "camera" | "room" | "ratio"> & { readonly work: Patch; readonly ground: Patch };

/** What the canvases show, kept between scenes, so that only changes are repainted. */
export interface SheetMemory {
  ground: string;
  work: readonly unknown[];
  /** Their position, and how they were painted; null before the first picture. */
  laid: (Laid & { readonly style: string }) | null;
}

/**
 * Paints a scene and follows its camera and playback; returns the function that stops it. If only the stock differs
 * from the previous scene, the worker, which has that stock, paints it, and the page shows it once ready.
 */
export function followScene(canvases: SheetCanvases, scene: SheetScene, memory: SheetMemory): () => void {
  const { under, over, given, holder } = canvases,
    { viewport, moving, blank, section, chuck, theme } = scene;
  const shop = under.getContext("bitmaprenderer"),
    pen = over.getContext("2d"),
    frame = given.getContext("bitmaprenderer");
  if (!shop || !pen || !frame) return () => undefined;
  const colours = pageColours(COLOURS),
    blanks = moving?.blanks ?? blank;
  const box = boundsOf(blanks.flat()),
    widest = { outer: farthest(blanks), along: 0 };
  const painter = stockPainter(moving ?? untouchedRun(blank)),
    playback = moving?.playback;
  const played = moving ? playedLayer(holder, moving.playback, () => playedSteps(moving.steps)) : null;
  const nowhere = (): Laid => ({
    camera: viewport.drawn(),
    room: drawnRoom(viewport.size()),
    ratio: viewport.ratio(),
    work: NOWHERE,
    ground: SPECK,
  });
  let { camera, room, ratio, work, ground } = memory.laid ?? nowhere();
  const style = JSON.stringify([theme, section, chuck]);
  /** True while the canvases show the previous scene. */
  let isOld = true;
  /** The camera the worker is painting for. */
  let awaited: Camera | null = null;
  const look = (): StockLook => ({ section, chuck, camera, colours, ratio, origin: work, ground, room });
  /** The view to paint next. */
  const nextLook = (): StockLook => {
    const next = { ...look(), camera: viewport.drawn(), room: drawnRoom(viewport.size()), ratio: viewport.ratio() };
    return {
      ...next,
      origin: (box && patchWithin(turnedPatchOf(box, next.camera, widest, next.ratio), next.room)) ?? NOWHERE,
      ground: (chuck && patchWithin(chuckPatch(chuck, next.camera, next.ratio), next.room)) ?? SPECK,
    };
  };
  /** Switches to the view that the picture is drawn for; later painting uses it. */
  const turn = () => {
    ({ camera, room, ratio, origin: work, ground } = nextLook());
    memory.laid = { camera, room, ratio, work, ground, style };
    isOld = false;
  };
  const shift = () => {
    shiftSheet(under, viewport, ground, camera);
    for (const sheet of [over, given, played?.canvas()]) if (sheet) shiftSheet(sheet, viewport, work, camera);
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
      fitCanvas(over, work, ratio);
      pen.setTransform(1, 0, 0, 1, 0, 0);
      pen.drawImage(given, 0, 0);
    }
    show("own");
  };
  const groundKey = () => JSON.stringify([theme, section, chuck, camera, room, ratio, work]);
  // A planned path keeps the previous stock, so no step of it needs painting.
  const workKey = () => [
    painter.rings(),
    moving?.surfaces,
    section,
    theme,
    camera,
    ratio,
    JSON.stringify([chuck, work]),
  ];
  const paintGround = () => {
    const seen = groundKey();
    if (seen === memory.ground) return;
    memory.ground = seen;
    fitCanvas(under, ground, ratio);
    const easel = new OffscreenCanvas(under.width, under.height),
      below = easel.getContext("2d");
    if (below) paintSurroundings(below, look());
    shop.transferFromImageBitmap(easel.transferToImageBitmap());
  };
  const paintAll = () => {
    awaited = null;
    played?.stop();
    if (playback) painter.goTo(playback.shown());
    turn();
    paintGround();
    if (shows === "played") show("own");
    const looks = workKey();
    if (looks.every((each, i) => each === memory.work[i])) return;
    memory.work = looks;
    show("own");
    fitCanvas(over, work, ratio);
    painter.paintAll(pen, look());
  };
  /** Shows the worker's picture. */
  const take = ({ work: stock, shop: around }: StockPictures, position: PlayPosition) => {
    awaited = null;
    played?.stop();
    painter.goTo(position);
    turn();
    [memory.ground, memory.work] = [groundKey(), workKey()];
    fitCanvas(under, ground, ratio);
    shop.transferFromImageBitmap(around);
    fitCanvas(given, work, ratio);
    frame.transferFromImageBitmap(stock);
    show("given");
    if (playback?.shown() !== position) paintMoved();
  };
  /** Has the workpiece painted for the present view; until then the old picture is shifted. */
  const repaintForCamera = async (of: KnownOutcome, position: PlayPosition) => {
    const next = nextLook();
    awaited = next.camera;
    const made = await stockPictures(of, next, position);
    if (awaited !== next.camera) return;
    if (made) take(made, position);
    else paintAll();
    shift();
  };
  const follow = () => {
    const of = moving && playback?.flows && viewport.drawn().xUp === camera.xUp ? knownOf(moving.steps) : null;
    const now = viewport.drawn();
    if (now === camera && !isOld) awaited = null;
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
    if (played?.follow(look)) {
      if (shows === "given") own();
      return show("played");
    }
    // The eye follows the tool, so during playback the material may follow every second frame.
    waits = !waits && playback.get().playing;
    if (waits || (shows !== "played" && isSamePlace(painter.at(), playback.shown()))) return;
    own();
    if (painter.paintChanges(pen, look(), playback.shown())) memory.work = [];
  };
  show(shows);
  follow();
  const ends = [viewport.subscribe(follow), playback?.subscribe(paintMoved), played?.stop];
  return () => {
    awaited = null;
    if (shows === "played") show("own");
    ends.forEach((end) => end?.());
  };
}
