import { useEffect, useRef } from "react";
import type { Step } from "../../kernel/step.ts";
import { toScreen } from "../../view/camera.ts";
import { edgeMark } from "../../view/edge-mark.ts";
import { tipAt } from "../../view/tip.ts";
import { useSettings } from "../settings/settings.ts";
import { SCALE_BELOW, SCALE_LEFT } from "./Axes.tsx";
import { holds } from "../use-media.ts";
import type { PlaybackStore } from "./playback-store.ts";
import { placeText } from "./running.ts";
import type { Viewport } from "./viewport.ts";

/** Width of the tools where they float over the right edge of the picture, pixels. */
const TOOLS = 56;

/** From the edge to the mark, from the mark to what it says, and from one of its lines to the next, pixels. */
const [INSET, BESIDE, LINE] = [14, 14, 15];

/** An arrow at the edge of the picture to a tool that stands outside it, with the place where it is. */
export function ToolAway({ viewport, playback, steps }: { readonly viewport: Viewport; readonly playback: PlaybackStore;
  readonly steps: readonly Step[] })
{
  const group = useRef<SVGGElement>(null);
  const language = useSettings((s) => s.language);
  useEffect(() => {
    const element = group.current, arrow = element?.querySelector("path"), text = element?.querySelector("text");
    const [first, second] = element?.querySelectorAll("tspan") ?? [];
    if (!element || !arrow || !text || !first || !second) return undefined;
    let room = { left: 0, right: 0, top: 0, bottom: 0 }, isShown = false;
    const paint = () => {
      const tip = tipAt(steps, playback.shown()), mark = tip && edgeMark(toScreen(viewport.get(), tip), room);
      if (isShown !== (mark !== null)) element.style.display = mark ? "" : "none";
      isShown = mark !== null;
      if (!mark || !tip) return;
      const { at: { x, y }, turn } = mark, toLeft = x > (room.left + room.right) / 2;
      const { x: diameter, z } = placeText(language, tip);
      arrow.setAttribute("transform", `translate(${x} ${y}) rotate(${turn})`);
      // Two short lines: what lies beside the mark stays to be seen.
      for (const line of [first, second]) line.setAttribute("x", String(x + (toLeft ? -BESIDE : BESIDE)));
      text.setAttribute("y", String(Math.min(Math.max(y, room.top + LINE), room.bottom - LINE) - 3));
      text.setAttribute("text-anchor", toLeft ? "end" : "start");
      first.textContent = `X⌀ ${diameter}`;
      second.textContent = `Z ${z}`;
    };
    const look = () => {
      const { width, height } = viewport.size(), floating = holds("narrow") && !holds("phone") ? TOOLS : 0;
      room = { left: SCALE_LEFT + INSET, right: width - INSET - floating, top: INSET, bottom: height - SCALE_BELOW - INSET };
      paint();
    };
    look();
    const ends = [viewport.subscribe(look), playback.subscribeReader(paint)];
    return () => {
      ends.forEach((end) => end());
      element.style.display = "none";
    };
  }, [steps, playback, viewport, language]);
  return (
    <g ref={group} className="tool-away" aria-hidden="true" style={{ display: "none" }}>
      <path d="M8 0L-6 6V-6Z" />
      <text className="number">
        <tspan />
        <tspan dy={LINE} />
      </text>
    </g>
  );
}
