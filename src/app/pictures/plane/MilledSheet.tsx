import { useEffect, useRef } from "react";
import { useTheme } from "../../base/use-theme-colours.ts";
import { followMilled, type MilledMemory, type MilledScene } from "./follow-milled.ts";

/**
 * Milled stock on a canvas no larger than the blank: painted whole for another view, and only near the tool during
 * playback; by the worker on its own layer once that is ready, else by the page.
 */
export function MilledSheet({ viewport, steps, playback, milled }: MilledScene) {
  const canvas = useRef<HTMLCanvasElement>(null),
    made = useRef<HTMLCanvasElement>(null),
    layers = useRef<HTMLDivElement>(null);
  const memory = useRef<MilledMemory>({ painted: null }),
    theme = useTheme(),
    shown = useRef(theme);
  useEffect(() => {
    const over = canvas.current,
      given = made.current,
      holder = layers.current;
    if (!over || !given || !holder) return undefined;
    if (shown.current !== theme) memory.current.painted = null;
    shown.current = theme;
    return followMilled({ over, given, holder }, { viewport, steps, playback, milled }, memory.current);
  }, [viewport, steps, playback, milled, theme]);
  return (
    <>
      <canvas ref={canvas} className="sheet material" />
      <canvas ref={made} className="sheet given" style={{ visibility: "hidden" }} />
      <div ref={layers} className="played" />
    </>
  );
}
