import { useEffect, useRef, type ReactNode } from "react";
import type { Bounds, Size } from "../../../view/camera.ts";
import { pageLength } from "../../base/unit.ts";
import type { Viewport } from "./viewport.ts";

/** Margin of a tool for its lines, pixels. */
export const LINE = 4;

/**
 * A tool, relative to the point that carries it, on a sheet no larger than itself: redrawn for another tool or zoom,
 * else only moved. `boxOf`: its box at a scale, with that margin, pixels. `centre`: what keeps its size, pixels.
 */
export function CarriedSheet({
  viewport,
  boxOf,
  centre,
  children,
}: {
  readonly viewport: Viewport;
  readonly boxOf: (scale: number, size: Size) => Bounds;
  readonly centre?: ReactNode;
  readonly children: ReactNode;
}) {
  const sheet = useRef<SVGSVGElement>(null),
    world = useRef<SVGGElement>(null),
    point = useRef<SVGGElement>(null);
  useEffect(() => {
    const element = sheet.current;
    if (!element) return undefined;
    let scale = 0,
      up: boolean | null = null;
    const draw = () => {
      const camera = viewport.drawn();
      if (camera.scale === scale && camera.xUp === up) return;
      [scale, up] = [camera.scale, camera.xUp];
      const { left, right, low, high } = boxOf(scale, viewport.size());
      const corner = { x: left, y: up ? -high : low },
        width = Math.ceil(right - left),
        height = Math.ceil(high - low);
      element.setAttribute("viewBox", `0 0 ${width} ${height}`);
      for (const [name, units] of Object.entries({ left: corner.x, top: corner.y, width, height }))
        element.style.setProperty(name, pageLength(units));
      world.current?.setAttribute("transform", `matrix(${scale} 0 0 ${up ? -scale : scale} ${-corner.x} ${-corner.y})`);
      point.current?.setAttribute("transform", `translate(${-corner.x} ${-corner.y})`);
    };
    draw();
    return viewport.subscribe(draw);
  }, [viewport, boxOf]);
  return (
    <svg ref={sheet} className="tool-sheet">
      <g ref={world}>{children}</g>
      {centre && <g ref={point}>{centre}</g>}
    </svg>
  );
}
