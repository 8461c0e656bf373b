import { useEffect, useRef } from "react";
import type { Pt } from "../../kernel/point.ts";
import type { Tool } from "../../kernel/tool.ts";
import { breakData, breakOf } from "../../view/cutting-tool/break-line.ts";
import { pageUnit } from "../unit.ts";
import { SCALE_BELOW, SCALE_LEFT } from "./Axes.tsx";
import type { Viewport } from "./viewport.ts";

/** From the edge of the picture to the break, pixels. */
const INSET = 14;

/** Where a shank leaves the picture it is cut off with a break line, which goes along the edge with the tool. */
export function BreakLine({ viewport, tool, tip, follow }: {
  readonly viewport: Viewport;
  readonly tool: Tool;
  /** Where the tip stands now; null: nowhere. */
  readonly tip: () => Pt | null;
  /** Calls when the tip has moved; returns what ends it. */
  readonly follow: (listener: () => void) => () => void;
}) {
  const sheet = useRef<SVGSVGElement>(null);
  useEffect(() => {
    const element = sheet.current, [ground, line] = element?.querySelectorAll("path") ?? [];
    if (!element || !tool.holder) return undefined;
    const unit = pageUnit();
    let width = -1, isShown = true;
    const place = () => {
      const at = tip(), { width: right, height } = viewport.size();
      const seen = { left: unit * SCALE_LEFT + INSET, right: right - INSET, top: INSET, bottom: height - unit * SCALE_BELOW - INSET };
      const broken = at && breakOf(tool, at, viewport.get(), seen);
      if ((broken !== null) !== isShown) {
        isShown = broken !== null;
        element.style.display = isShown ? "" : "none";
      }
      if (!broken) return;
      element.style.transform = `translate(${broken.at.x}px, ${broken.at.y}px) rotate(${broken.turn}deg)`;
      if (broken.width === width) return;
      width = broken.width;
      const data = breakData(width, INSET + unit * SCALE_LEFT);
      ground?.setAttribute("d", data.ground);
      line?.setAttribute("d", data.line);
    };
    place();
    const ends = [viewport.subscribe(place), follow(place)];
    return () => ends.forEach((end) => end());
  }, [viewport, tool, tip, follow]);
  return tool.holder && (
    <svg ref={sheet} className="chip-sheet" width="1" height="1" aria-hidden="true">
      <path className="break-ground" />
      <path className="break-line" />
    </svg>
  );
}
