import { useCallback, useEffect, useRef } from "react";
import type { Step } from "../../kernel/step.ts";
import { toScreen } from "../../view/camera.ts";
import { edgeMark } from "../../view/edge-mark.ts";
import { tipAt } from "../../view/tip.ts";
import { useSettings } from "../settings/settings.ts";
import { SCALE_BELOW, SCALE_LEFT } from "./Axes.tsx";
import { holds } from "../use-media.ts";
import type { PlaybackStore } from "./playback-store.ts";
import { placeText } from "./running.ts";
import { useEachPicture } from "./use-playback.ts";
import type { Viewport } from "./viewport.ts";

/** Width of the tools where they float over the right edge of the picture, pixels. */
const TOOLS = 56;

/** From the edge to the mark, and from the mark to what it says, pixels. */
const [INSET, BESIDE] = [14, 14];

/** An arrow at the edge of the picture to a tool that stands outside it, with the place where it is. */
export function ToolAway({ viewport, playback, steps }: { readonly viewport: Viewport; readonly playback: PlaybackStore;
  readonly steps: readonly Step[] })
{
  const group = useRef<SVGGElement>(null);
  const language = useSettings((s) => s.language);
  const paint = useCallback(() => {
    const element = group.current, tip = tipAt(steps, playback.shown());
    if (!element) return;
    const { width, height } = viewport.size();
    const floating = holds("narrow") && !holds("phone") ? TOOLS : 0;
    const shown = { left: SCALE_LEFT + INSET, right: width - INSET - floating, top: INSET, bottom: height - SCALE_BELOW - INSET };
    const mark = tip && edgeMark(toScreen(viewport.get(), tip), shown);
    element.style.display = mark ? "" : "none";
    if (!mark || !tip) return;
    const { at: { x, y }, turn } = mark, toLeft = x > (shown.left + shown.right) / 2;
    element.querySelector("path")?.setAttribute("transform", `translate(${x} ${y}) rotate(${turn})`);
    const text = element.querySelector("text"), { x: diameter, z } = placeText(language, tip);
    if (!text) return;
    text.setAttribute("x", String(x + (toLeft ? -BESIDE : BESIDE)));
    text.setAttribute("y", String(Math.max(y, INSET + 4) + 4));
    text.setAttribute("text-anchor", toLeft ? "end" : "start");
    text.textContent = `X⌀ ${diameter}  Z ${z}`;
  }, [steps, playback, viewport, language]);
  useEachPicture(playback, paint);
  useEffect(() => viewport.subscribe(paint), [viewport, paint]);
  return (
    <g ref={group} className="tool-away" aria-hidden="true" style={{ display: "none" }}>
      <path d="M8 0L-6 6V-6Z" />
      <text className="number" />
    </g>
  );
}
