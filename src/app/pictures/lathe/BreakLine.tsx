import { useEffect, useRef } from "react";
import type { Pt } from "../../../kernel/geometry/point.ts";
import type { Tool } from "../../../kernel/plan/tool.ts";
import { breakData, breakOf } from "../../../view/cutting-tool/break-line.ts";
import { pageLength } from "../../base/unit.ts";
import { SCALE_BELOW, SCALE_LEFT } from "./Axes.tsx";
import type { MovingAnchor } from "./moving-anchor.ts";
import type { Viewport } from "./viewport.ts";

/** From the edge of the picture to the break, pixels. */
const INSET = 14;

/** The break line where a shank leaves the picture. It moves along the edge with the tool. */
export function BreakLine({
  viewport,
  tool,
  carrying,
}: {
  readonly viewport: Viewport;
  readonly tool: Tool;
  readonly carrying: MovingAnchor;
}) {
  const sheet = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const element = sheet.current,
      [ground, line] = element?.querySelectorAll("path") ?? [];
    if (!element || !tool.holder) return undefined;
    const broken = (tip: Pt) => {
      const { width, height } = viewport.size();
      const seen = {
        left: SCALE_LEFT + INSET,
        right: width - INSET,
        top: INSET,
        bottom: height - SCALE_BELOW - INSET,
      };
      return breakOf(tool, tip, viewport.get(), seen);
    };
    let isShown = true;
    const show = () => {
      const tip = carrying.tip(),
        now = tip && broken(tip);
      if ((now !== null) !== isShown) {
        isShown = now !== null;
        element.style.display = isShown ? "" : "none";
      }
      const data = now && breakData(now.width, INSET + SCALE_LEFT);
      if (!data || line?.getAttribute("d") === data.line) return;
      ground?.setAttribute("d", data.ground);
      line?.setAttribute("d", data.line);
    };
    const gliding = carrying.carry(element, (tip) => {
      const now = broken(tip);
      return now && `translate(${pageLength(now.at.x)}, ${pageLength(now.at.y)}) rotate(${now.turn}deg)`;
    });
    const look = () => {
      show();
      gliding.recompute();
    };
    show();
    const ends = [viewport.subscribe(look), carrying.follow(show), gliding.end];
    return () => ends.forEach((end) => end());
  }, [viewport, tool, carrying]);
  return (
    tool.holder && (
      <div ref={sheet} className="tool-carrier" aria-hidden="true">
        <svg className="chip-sheet" viewBox="0 0 1 1">
          <path className="break-ground" />
          <path className="break-line" />
        </svg>
      </div>
    )
  );
}
