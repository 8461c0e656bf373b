import { useEffect, useRef } from "react";
import type { Ring } from "../../kernel/point.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import type { ChuckDrawing } from "../../view/material/chuck.ts";
import { paintMaterial } from "../../view/material/paint.ts";
import type { Patch } from "../../view/material/pen.ts";
import type { MaterialColours } from "../../view/material/easel.ts";
import { patchWithin, touchedBetween, turnedPatchOf } from "../../view/material/touched.ts";
import type { SectionView } from "../settings/settings.ts";
import { fitCanvas } from "./fit-canvas.ts";
import { UNTOUCHED, type Moving } from "./moving.ts";
import { pageColours, useTheme } from "./use-theme-colours.ts";
import type { Viewport } from "./viewport.ts";

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

/** How far from the axis there is material, mm. */
const farthest = (rings: readonly Ring[]) => rings.reduce((most, ring) => ring.reduce((far, p) => Math.max(far, p.r), most), 0);

/** Whether nothing but rapids runs between two positions: they leave surfaces as they are. */
const onlyRapids = ({ steps }: Moving, one: PlayPosition, other: PlayPosition) =>
  steps.slice(Math.min(one.step, other.step), Math.max(one.step, other.step) + 1).every((step) => step.move.kind === "rapid");

/** The material on a canvas of its own: painted whole for another look at it, and only where the tool is while it plays. */
export function MaterialSheet({ viewport, moving, blank, section, chuck }: {
  readonly viewport: Viewport;
  readonly moving: Moving | null;
  /** What stands there before anything moves. */
  readonly blank: readonly Ring[];
  readonly section: SectionView;
  readonly chuck: ChuckDrawing | null;
}) {
  const canvas = useRef<HTMLCanvasElement>(null), theme = useTheme();
  useEffect(() => {
    const element = canvas.current, pen = element?.getContext("2d");
    if (!element || !pen) return undefined;
    const colours = pageColours(COLOURS), surfaces = moving?.surfaces ?? UNTOUCHED;
    let rings: readonly Ring[] = blank, now = START;
    const stock = () => {
      if (!moving) return;
      now = moving.playback.shown();
      rings = moving.stockAt(now);
    };
    let ratio = devicePixelRatio;
    const paint = (patch: Patch) => paintMaterial(pen, { rings, section, now, surfaces, chuck }, viewport.get(), { colours, ratio }, patch);
    const paintAll = () => {
      const { width, height } = viewport.size();
      ratio = devicePixelRatio;
      fitCanvas(element, pen, { width, height });
      paint({ x: 0, y: 0, width, height });
    };
    const paintMoved = () => {
      const [before, were] = [now, rings];
      stock();
      if (!moving || (rings === were && onlyRapids(moving, before, now))) return;
      const touched = moving.isSameBlank(before, now) ? touchedBetween(moving.steps, before, now) : "all";
      if (touched === "all") return paintAll();
      if (!touched) return;
      const reach = { outer: Math.max(farthest(were), farthest(rings)), along: surfaces.lead(now) };
      const patch = patchWithin(turnedPatchOf(touched, viewport.get(), reach, ratio), viewport.size());
      if (patch) paint(patch);
    };
    stock();
    paintAll();
    const ends = [viewport.subscribe(paintAll), moving?.playback.subscribe(paintMoved)];
    return () => ends.forEach((end) => end?.());
  }, [viewport, moving, blank, section, chuck, theme]);
  return <canvas ref={canvas} className="sheet material" />;
}
