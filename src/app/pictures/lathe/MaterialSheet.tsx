import { useEffect, useRef } from "react";
import { followScene, type SheetMemory, type SheetScene } from "./follow-scene.ts";
import { useTheme } from "../../base/use-theme-colours.ts";

/**
 * The chuck, on a background repainted only for another view, and the workpiece on a canvas no larger than the blank.
 * With each frame the browser copies every canvas that can be painted, so the background is a bitmap. During playback
 * the material is painted near the tool: by the worker on its own layer once that is ready, else by the page.
 */
export function MaterialSheet({ viewport, moving, blank, section, chuck }: Omit<SheetScene, "theme">) {
  const ground = useRef<HTMLCanvasElement>(null),
    canvas = useRef<HTMLCanvasElement>(null),
    made = useRef<HTMLCanvasElement>(null);
  const layers = useRef<HTMLDivElement>(null),
    memory = useRef<SheetMemory>({ ground: "", work: [], laid: null }),
    theme = useTheme();
  useEffect(() => {
    const under = ground.current,
      over = canvas.current,
      given = made.current,
      holder = layers.current;
    if (!under || !over || !given || !holder) return undefined;
    return followScene(
      { under, over, given, holder },
      { viewport, moving, blank, section, chuck, theme },
      memory.current,
    );
  }, [viewport, moving, blank, section, chuck, theme]);
  return (
    <>
      <canvas ref={ground} className="sheet" />
      <canvas ref={canvas} className="sheet material" />
      <canvas ref={made} className="sheet given" style={{ visibility: "hidden" }} />
      <div ref={layers} className="played" />
    </>
  );
}
