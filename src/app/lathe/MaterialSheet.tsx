import { useEffect, useRef } from "react";
import type { Ring } from "../../kernel/point.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import { boundsOf } from "../../view/bounds.ts";
import type { ChuckDrawing } from "../../view/material/chuck.ts";
import { paintMaterial } from "../../view/material/paint.ts";
import type { Patch } from "../../view/material/pen.ts";
import type { MaterialColours } from "../../view/material/easel.ts";
import { patchWithin, touchedBetween, turnedPatchOf } from "../../view/material/touched.ts";
import type { SectionView } from "../settings/settings.ts";
import { fitCanvas } from "./fit-canvas.ts";
import { UNTOUCHED, type Moving } from "./moving.ts";
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

const START: PlayPosition = { step: 0, fraction: 0 };
const NOWHERE: Patch = { x: 0, y: 0, width: 0, height: 0 };

/** How far from the axis there is material, mm. */
const farthest = (rings: readonly Ring[]) => rings.reduce((most, ring) => ring.reduce((far, p) => Math.max(far, p.r), most), 0);

/** Whether nothing but rapids runs between two positions: they leave surfaces as they are. */
const onlyRapids = ({ steps }: Moving, one: PlayPosition, other: PlayPosition) =>
  steps.slice(Math.min(one.step, other.step), Math.max(one.step, other.step) + 1).every((step) => step.move.kind === "rapid");

/**
 * The chuck on a ground that is painted for another look at it only, and the work on a canvas no larger than the blank. With each picture
 * the browser copies every canvas that can be painted on, touched or not: so the ground only shows a bitmap. While it plays the work is
 * painted where the tool is.
 */
export function MaterialSheet({ viewport, moving, blank, section, chuck }: {
  readonly viewport: Viewport;
  readonly moving: Moving | null;
  /** What stands there before anything moves. */
  readonly blank: readonly Ring[];
  readonly section: SectionView;
  readonly chuck: ChuckDrawing | null;
}) {
  const ground = useRef<HTMLCanvasElement>(null), canvas = useRef<HTMLCanvasElement>(null), theme = useTheme();
  /** What the ground shows, and what the work does: painted again only when that is something else. */
  const shown = useRef(""), worked = useRef<readonly unknown[]>([]);
  useEffect(() => {
    const under = ground.current, shop = under?.getContext("bitmaprenderer"), over = canvas.current, pen = over?.getContext("2d");
    if (!under || !shop || !over || !pen) return undefined;
    const colours = pageColours(COLOURS), surfaces = moving?.surfaces ?? UNTOUCHED, blanks = moving?.blanks ?? blank;
    const box = boundsOf(blanks.flat()), widest = { outer: farthest(blanks), along: 0 };
    let rings: readonly Ring[] = blank, now = START, ratio = devicePixelRatio, work: Patch = NOWHERE, camera = viewport.drawn();
    const stock = () => {
      if (!moving) return;
      now = moving.playback.shown();
      rings = moving.stockAt(now);
    };
    const paintWork = (patch: Patch) =>
      paintMaterial(pen, { rings, section, now, surfaces, chuck }, viewport.drawn(), { colours, ratio, origin: work }, patch);
    const paintGround = () => {
      const whole = drawnRoom(viewport.size()), seen = JSON.stringify([theme, section, chuck, viewport.drawn(), whole, ratio, work]);
      if (seen === shown.current) return;
      shown.current = seen;
      const easel = new OffscreenCanvas(1, 1), below = easel.getContext("2d");
      if (!below) return;
      fitCanvas(under, whole);
      [easel.width, easel.height] = [under.width, under.height];
      paintMaterial(below, { rings: [], section, now, surfaces, chuck }, viewport.drawn(), { colours, ratio, origin: whole }, whole);
      below.setTransform(ratio, 0, 0, ratio, -whole.x * ratio, -whole.y * ratio);
      below.clearRect(work.x, work.y, work.width, work.height);
      shop.transferFromImageBitmap(easel.transferToImageBitmap());
    };
    const follow = () => {
      if (viewport.drawn() !== camera) paintAll();
      shiftSheet(under, viewport, drawnRoom(viewport.size()));
      shiftSheet(over, viewport, work);
    };
    const paintAll = () => {
      camera = viewport.drawn();
      ratio = devicePixelRatio;
      work = (box && patchWithin(turnedPatchOf(box, viewport.drawn(), widest, ratio), drawnRoom(viewport.size()))) ?? NOWHERE;
      paintGround();
      // A planned path has the stock of before: nothing is painted then, whatever step of the new path that is.
      const looks = [rings, surfaces, section, theme, viewport.drawn(), ratio, JSON.stringify([chuck, work])];
      if (looks.every((each, i) => each === worked.current[i])) return;
      worked.current = looks;
      fitCanvas(over, work);
      paintWork(work);
    };
    let waits = false;
    const paintMoved = () => {
      // The eye follows the tool: while it plays the material follows with every second picture.
      waits = !waits && moving?.playback.get().playing === true;
      if (waits) return;
      const [before, were] = [now, rings];
      stock();
      if (!moving || (rings === were && onlyRapids(moving, before, now))) return;
      const touched = moving.isSameBlank(before, now) ? touchedBetween(moving.steps, before, now) : "all";
      if (!touched) return;
      worked.current = [];
      if (touched === "all") return paintWork(work);
      const reach = { outer: Math.max(farthest(were), farthest(rings)), along: surfaces.lead(now) };
      const patch = patchWithin(turnedPatchOf(touched, viewport.drawn(), reach, ratio), drawnRoom(viewport.size()));
      if (patch) paintWork(patch);
    };
    stock();
    paintAll();
    follow();
    const ends = [viewport.subscribe(follow), moving?.playback.subscribe(paintMoved)];
    return () => ends.forEach((end) => end?.());
  }, [viewport, moving, blank, section, chuck, theme]);
  return (
    <>
      <canvas ref={ground} className="sheet" />
      <canvas ref={canvas} className="sheet material" />
    </>
  );
}
