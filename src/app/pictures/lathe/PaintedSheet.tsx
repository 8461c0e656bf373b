import { useEffect, useRef } from "react";
import type { MachineSide } from "../../../program/run/plane-index.ts";
import { followSheet, type PaintedScene, type SheetMemory } from "./follow-sheet.ts";

/**
 * The surroundings, on a background repainted only for another view, and the stock on a canvas no larger than the
 * blank. With each frame the browser copies every canvas that can be painted, so the background is a bitmap. During
 * playback the stock is painted near the tool: by the worker on its own layer once that is ready, else by the page.
 * `scene` makes the content, with the colours of the page.
 */
export function PaintedSheet<Side extends MachineSide>({ scene }: { readonly scene: () => PaintedScene<Side> }) {
  const ground = useRef<HTMLCanvasElement>(null),
    canvas = useRef<HTMLCanvasElement>(null),
    made = useRef<HTMLCanvasElement>(null);
  const layers = useRef<HTMLDivElement>(null),
    memory = useRef<SheetMemory>({ ground: "", work: [], laid: null });
  useEffect(() => {
    const under = ground.current,
      over = canvas.current,
      given = made.current,
      holder = layers.current;
    if (!under || !over || !given || !holder) return undefined;
    return followSheet({ under, over, given, holder }, scene(), memory.current);
  }, [scene]);
  return (
    <>
      <canvas ref={ground} className="sheet" />
      <canvas ref={canvas} className="sheet material" />
      <canvas ref={made} className="sheet given" style={{ visibility: "hidden" }} />
      <div ref={layers} className="played" />
    </>
  );
}
