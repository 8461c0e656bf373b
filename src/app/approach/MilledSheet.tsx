import { useEffect, useRef } from "react";
import type { PlaneStep } from "../../program/plane-types.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import { paintMilled, toneOfDepth, type MilledColours } from "../../view/approach/milled-paint.ts";
import { milledBetween } from "../../view/approach/touched-plane.ts";
import type { Patch } from "../../view/material/pen.ts";
import { patchOf, patchWithin } from "../../view/material/touched.ts";
import { fitCanvas } from "../lathe/fit-canvas.ts";
import type { PlaybackStore } from "../lathe/playback-store.ts";
import { pageColours, useTheme } from "../lathe/use-theme-colours.ts";
import { drawnRoom, type Viewport } from "../lathe/viewport.ts";
import { shiftSheet } from "../lathe/World.tsx";
import type { GrowingStock } from "./milled.ts";

const COLOURS = { ground: "--material", hatch: "--material-hatch", edge: "--line-strong", step: "--line-strong" } as const satisfies Record<
  keyof MilledColours,
  string
>;

/** The page's name for the tone of a depth. */
export const toneName = (depth: number, depths: number): string => `--milled-${toneOfDepth(depth, depths) + 1}`;

/** Milled stock on a canvas of its own: painted whole for another look at it, and only where the tool is while it plays. */
export function MilledSheet({ viewport, steps, playback, milled: { stock, subscribe } }: { readonly viewport: Viewport;
  readonly steps: readonly PlaneStep[]; readonly playback: PlaybackStore; readonly milled: GrowingStock })
{
  const canvas = useRef<HTMLCanvasElement>(null), wasPainted = useRef(false), theme = useTheme();
  useEffect(() => {
    const element = canvas.current, pen = element?.getContext("2d");
    if (!element || !pen) return undefined;
    const colours = pageColours(COLOURS), depths = stock.limits.length - 1;
    const all = Array.from({ length: depths }, (_, i) => toneName(i, depths));
    const named = pageColours(Object.fromEntries(all.map((name) => [name, name])));
    const tones = all.map((name) => named[name] ?? "");
    let at: PlayPosition = { step: 0, fraction: 0 }, moment = stock.at(at), reached = 0, camera = viewport.drawn();
    const look = () => {
      [at, reached] = [playback.shown(), stock.reached()];
      moment = stock.at(at);
    };
    const paint = (patch: Patch) => paintMilled(pen, { moment, tones }, viewport.drawn(), colours, patch);
    const paintAll = () => {
      const room = drawnRoom(viewport.size()), ratio = devicePixelRatio;
      camera = viewport.drawn();
      fitCanvas(element, room);
      pen.setTransform(ratio, 0, 0, ratio, -room.x * ratio, -room.y * ratio);
      paint(room);
    };
    const follow = () => {
      if (viewport.drawn() !== camera) paintAll();
      shiftSheet(element, viewport, drawnRoom(viewport.size()));
    };
    const paintMoved = () => {
      const before = at, { step, fraction } = playback.shown();
      if (before.step === step && before.fraction === fraction) return;
      look();
      const touched = stock.isSameBody(before.step, step) ? milledBetween(steps, before, at) : "all";
      if (touched === "all") return paintAll();
      const patch = touched && patchWithin(patchOf(touched, viewport.drawn(), devicePixelRatio), drawnRoom(viewport.size()));
      if (patch) paint(patch);
    };
    const paintGrown = () => {
      if (reached >= at.step) return;
      look();
      if (!wasPainted.current || reached >= at.step) paintAll();
    };
    look();
    // After a change of the program the stock of before stays until the new one is cut as far.
    wasPainted.current &&= reached < at.step;
    if (!wasPainted.current) paintAll();
    wasPainted.current = true;
    follow();
    const ends = [viewport.subscribe(follow), playback.subscribe(paintMoved), subscribe(paintGrown)];
    return () => ends.forEach((end) => end());
  }, [viewport, steps, playback, stock, subscribe, theme]);
  return <canvas ref={canvas} className="sheet material" />;
}
