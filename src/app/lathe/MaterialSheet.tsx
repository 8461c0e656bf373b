import { useEffect, useRef } from "react";
import type { Ring } from "../../kernel/point.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import { paintMaterial, type MaterialColours } from "../../view/material/paint.ts";
import type { Patch } from "../../view/material/pen.ts";
import { patchOf, patchWithin, touchedBetween } from "../../view/material/touched.ts";
import { fitCanvas } from "./fit-canvas.ts";
import type { Moving } from "./moving.ts";
import { pageColours, useTheme } from "./use-theme-colours.ts";
import type { Viewport } from "./viewport.ts";

const COLOURS = { ground: "--material", hatch: "--material-hatch", edge: "--line-strong" } as const satisfies Record<keyof MaterialColours,
  string>;

/** The material on a canvas of its own: painted whole for another look at it, and only where the tool is while it plays. */
export function MaterialSheet({ viewport, moving, blank, full }: {
  readonly viewport: Viewport;
  readonly moving: Moving | null;
  /** What stands there before anything moves. */
  readonly blank: readonly Ring[];
  /** Both sides of the axis are cut. */
  readonly full: boolean;
}) {
  const canvas = useRef<HTMLCanvasElement>(null), theme = useTheme();
  useEffect(() => {
    const element = canvas.current, pen = element?.getContext("2d");
    if (!element || !pen) return undefined;
    const colours = pageColours(COLOURS);
    let rings: readonly Ring[] = blank, at: PlayPosition | null = null;
    const stock = () => {
      if (!moving) return;
      at = moving.playback.shown();
      rings = moving.stockAt(at);
    };
    const paint = (patch: Patch) => paintMaterial(pen, { rings, full }, viewport.get(), colours, patch);
    const paintAll = () => {
      const { width, height } = viewport.size();
      fitCanvas(element, pen, { width, height });
      paint({ x: 0, y: 0, width, height });
    };
    const paintMoved = () => {
      const [before, were] = [at, rings];
      stock();
      if (rings === were || !moving) return;
      const touched = before && at && moving.isSameBlank(before, at) ? touchedBetween(moving.steps, before, at) : "all";
      if (touched === "all") return paintAll();
      if (!touched) return;
      for (const mirror of full ? [false, true] : [false]) {
        const patch = patchWithin(patchOf(touched, viewport.get(), mirror, devicePixelRatio), viewport.size());
        if (patch) paint(patch);
      }
    };
    stock();
    paintAll();
    const ends = [viewport.subscribe(paintAll), moving?.playback.subscribe(paintMoved)];
    return () => ends.forEach((end) => end?.());
  }, [viewport, moving, blank, full, theme]);
  return <canvas ref={canvas} className="sheet material" />;
}
