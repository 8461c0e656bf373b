import { useCallback } from "react";
import type { PlaneStep } from "../../../program/tools/plane-types.ts";
import { toneOfDepth, type MilledColours } from "../../../view/approach/milled-paint.ts";
import { milledPainter } from "../../../view/approach/milled-painter.ts";
import { patchOf, patchWithin } from "../../../view/material/changed-box.ts";
import { pageColours, useTheme } from "../../base/use-theme-colours.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { NOWHERE, type PaintedScene } from "../lathe/follow-sheet.ts";
import { PaintedSheet } from "../lathe/PaintedSheet.tsx";
import { knownOf } from "../lathe/played-layer.ts";
import type { Viewport } from "../lathe/viewport.ts";
import type { GrowingStock } from "./milled.ts";

const COLOURS = {
  ground: "--material",
  edge: "--line-strong",
  step: "--line-strong",
} as const satisfies Record<keyof MilledColours, string>;

/** The CSS property of the tone of a depth. */
export const toneName = (depth: number, depths: number): string => `--milled-${toneOfDepth(depth, depths) + 1}`;

/** Milled stock from above, in tones of its depths. */
export function MilledSheet({
  viewport,
  steps,
  playback,
  milled: { stock, blank, subscribe },
}: {
  readonly viewport: Viewport;
  readonly steps: readonly PlaneStep[];
  readonly playback: PlaybackStore;
  readonly milled: GrowingStock;
}) {
  const theme = useTheme();
  const scene = useCallback((): PaintedScene<"plane"> => {
    const count = stock.limits.length - 1,
      names = Array.from({ length: count }, (_, i) => toneName(i, count));
    const named = pageColours(Object.fromEntries(names.map((name) => [name, name]))),
      colours = pageColours(COLOURS),
      tones = names.map((name) => named[name] ?? "");
    return {
      viewport,
      playback,
      painter: milledPainter(steps, stock),
      style: String(theme),
      known: () => knownOf(steps, "plane"),
      growing: { reached: stock.reached, subscribe },
      look: ({ room, ...view }) => ({
        ...view,
        colours,
        tones,
        origin: (blank && patchWithin(patchOf(blank, view.camera, view.ratio), room)) ?? NOWHERE,
        ground: null,
      }),
    };
  }, [viewport, steps, playback, stock, blank, subscribe, theme]);
  return <PaintedSheet scene={scene} />;
}
