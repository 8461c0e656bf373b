import { useEffect, useRef } from "react";
import type { Ring } from "../../kernel/point.ts";
import { boundsOf } from "../../view/bounds.ts";
import type { ChuckDrawing } from "../../view/material/chuck.ts";
import type { Patch } from "../../view/material/pen.ts";
import type { MaterialColours } from "../../view/material/easel.ts";
import { farthest, stockPainter, type PaintedRun, type StockLook } from "../../view/material/stock-painter.ts";
import { patchWithin, turnedPatchOf } from "../../view/material/touched.ts";
import type { SectionView } from "../settings/settings.ts";
import { fitCanvas } from "./fit-canvas.ts";
import { UNTOUCHED, type Moving } from "./moving.ts";
import { playedLayer } from "./played-layer.ts";
import { pageColours, useTheme } from "./use-theme-colours.ts";
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

/** A blank that nothing moves at. */
const still = (blank: readonly Ring[]): PaintedRun => ({ steps: [], stockAt: () => blank, isSameBlank: () => true, surfaces: UNTOUCHED });

/**
 * The chuck on a ground that is painted for another look at it only, and the work on a canvas no larger than the blank. With each picture
 * the browser copies every canvas that can be painted on, touched or not: so the ground only shows a bitmap. While it plays the work is
 * painted where the tool is: by the worker on a layer of its own as soon as that shows it, until then and where it cannot by the page.
 */
export function MaterialSheet({ viewport, moving, blank, section, chuck }: {
  readonly viewport: Viewport;
  readonly moving: Moving | null;
  /** What stands there before anything moves. */
  readonly blank: readonly Ring[];
  readonly section: SectionView;
  readonly chuck: ChuckDrawing | null;
}) {
  const ground = useRef<HTMLCanvasElement>(null), canvas = useRef<HTMLCanvasElement>(null), holder = useRef<HTMLDivElement>(null);
  const theme = useTheme();
  /** What the ground shows, and what the work does: painted again only when that is something else. */
  const shown = useRef(""), worked = useRef<readonly unknown[]>([]);
  useEffect(() => {
    const under = ground.current, shop = under?.getContext("bitmaprenderer"), over = canvas.current, pen = over?.getContext("2d");
    if (!under || !shop || !over || !pen) return undefined;
    const colours = pageColours(COLOURS), blanks = moving?.blanks ?? blank;
    const box = boundsOf(blanks.flat()), widest = { outer: farthest(blanks), along: 0 };
    const painter = stockPainter(moving ?? still(blank)), playback = moving?.playback;
    const played = moving && holder.current ? playedLayer(holder.current, moving.steps, moving.playback) : null;
    let ratio = devicePixelRatio, work: Patch = NOWHERE, camera = viewport.drawn();
    const look = (): StockLook => ({ section, chuck, camera, colours, ratio, origin: work, room: drawnRoom(viewport.size()) });
    const paintGround = () => {
      const whole = drawnRoom(viewport.size()), seen = JSON.stringify([theme, section, chuck, camera, whole, ratio, work]);
      if (seen === shown.current) return;
      shown.current = seen;
      const easel = new OffscreenCanvas(1, 1), below = easel.getContext("2d");
      if (!below) return;
      fitCanvas(under, whole);
      [easel.width, easel.height] = [under.width, under.height];
      stockPainter(still([])).all(below, { ...look(), origin: whole });
      below.setTransform(ratio, 0, 0, ratio, -whole.x * ratio, -whole.y * ratio);
      below.clearRect(work.x, work.y, work.width, work.height);
      shop.transferFromImageBitmap(easel.transferToImageBitmap());
    };
    const follow = () => {
      if (viewport.drawn() !== camera) paintAll();
      shiftSheet(under, viewport, drawnRoom(viewport.size()));
      shiftSheet(over, viewport, work);
      const layer = played?.canvas();
      if (layer) shiftSheet(layer, viewport, work);
    };
    const paintAll = () => {
      played?.stop();
      over.style.visibility = "";
      if (playback) painter.goTo(playback.shown());
      camera = viewport.drawn();
      ratio = devicePixelRatio;
      work = (box && patchWithin(turnedPatchOf(box, camera, widest, ratio), drawnRoom(viewport.size()))) ?? NOWHERE;
      paintGround();
      // A planned path has the stock of before: nothing is painted then, whatever step of the new path that is.
      const looks = [painter.rings(), moving?.surfaces, section, theme, camera, ratio, JSON.stringify([chuck, work])];
      if (looks.every((each, i) => each === worked.current[i])) return;
      worked.current = looks;
      fitCanvas(over, work);
      painter.all(pen, look());
    };
    let waits = false;
    const paintMoved = () => {
      if (!playback) return;
      const isPlayed = played?.follow(look) ?? false;
      over.style.visibility = isPlayed ? "hidden" : "";
      // The eye follows the tool: while it plays the material follows with every second picture.
      waits = !waits && playback.get().playing;
      if (!isPlayed && !waits && painter.follow(pen, look(), playback.shown())) worked.current = [];
    };
    paintAll();
    follow();
    const ends = [viewport.subscribe(follow), playback?.subscribe(paintMoved), played?.stop];
    return () => ends.forEach((end) => end?.());
  }, [viewport, moving, blank, section, chuck, theme]);
  return (
    <>
      <canvas ref={ground} className="sheet" />
      <canvas ref={canvas} className="sheet material" />
      <div ref={holder} className="played" />
    </>
  );
}
