import { useEffect, useMemo, useRef } from "react";
import { insertOutline } from "../../kernel/insert.ts";
import type { Pt } from "../../kernel/point.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import type { Tool } from "../../kernel/tool.ts";
import { boundsOf, common, grownBounds } from "../../view/bounds.ts";
import { toScreen, type Bounds } from "../../view/camera.ts";
import { toolBox } from "../../view/cutting-tool/drawing.ts";
import { tipAt } from "../../view/tip.ts";
import { BreakLine } from "./BreakLine.tsx";
import { ChipSheet } from "./ChipSheet.tsx";
import { DrawnTool } from "./DrawnTool.tsx";
import { stepIndex, type Moving } from "./moving.ts";
import { usePlayback } from "./use-playback.ts";
import type { Viewport } from "./viewport.ts";

/** Pixels round the drawing of a tool for its lines. */
const LINE = 4;
/** As much of a holder is drawn as fits into this many pictures. */
const PICTURES = 1.5;

/** The box of an insert and the one of the whole tool. */
function boxesOf(tool: Tool): { readonly insert: Bounds; readonly all: Bounds } {
  const insert = boundsOf(insertOutline(tool, CHORD)) ?? { left: -1, right: 1, low: -1, high: 1 };
  return { insert, all: toolBox(tool) ?? insert };
}

/**
 * A tool on a sheet no larger than itself, and what lies at its tip. The sheet is drawn anew for another tool or another zoom; where the
 * tip goes both follow with one transform, which costs the page no layout and no painting.
 */
function Sheet({ viewport, tool, tip, follow, children }: {
  readonly viewport: Viewport;
  readonly tool: Tool;
  /** Where the tip stands now; null: nowhere. */
  readonly tip: () => Pt | null;
  /** Calls when the tip has moved; returns what ends it. */
  readonly follow: (listener: () => void) => () => void;
  /** Drawn over the tool, its origin at the tip. */
  readonly children?: React.ReactNode;
}) {
  const carrier = useRef<HTMLDivElement>(null), sheet = useRef<SVGSVGElement>(null), world = useRef<SVGGElement>(null);
  const boxes = useMemo(() => boxesOf(tool), [tool]);
  useEffect(() => {
    const element = sheet.current, carried = carrier.current;
    if (!element || !carried) return undefined;
    const place = () => {
      const at = tip();
      if (!at) return;
      const camera = viewport.get(), { x, y } = toScreen(camera, at), grown = camera.scale / viewport.drawn().scale;
      carried.style.transform = `translate(${x}px, ${y}px)${grown === 1 ? "" : ` scale(${grown})`}`;
    };
    let scale = 0, up: boolean | null = null;
    const draw = () => {
      const camera = viewport.drawn(), size = viewport.size();
      if (camera.scale !== scale || camera.xUp !== up) {
        [scale, up] = [camera.scale, camera.xUp];
        const far = (PICTURES * Math.max(size.width, size.height)) / scale;
        const { left, right, low, high } = common(boxes.all, grownBounds(boxes.insert, far));
        const top = up ? -high : low;
        const corner = { x: left * scale - LINE, y: top * scale - LINE };
        element.style.left = `${corner.x}px`;
        element.style.top = `${corner.y}px`;
        element.setAttribute("width", String(Math.ceil((right - left) * scale + 2 * LINE)));
        element.setAttribute("height", String(Math.ceil((high - low) * scale + 2 * LINE)));
        world.current?.setAttribute("transform", `matrix(${scale} 0 0 ${up ? -scale : scale} ${-corner.x} ${-corner.y})`);
      }
      place();
    };
    draw();
    const ends = [viewport.subscribe(draw), follow(place)];
    return () => ends.forEach((end) => end());
  }, [viewport, boxes, tip, follow]);
  return (
    <>
      <div ref={carrier} className="tool-carrier">
        <svg ref={sheet} className="tool-sheet">
          <g ref={world}>
            <DrawnTool tool={tool} />
          </g>
        </svg>
        {children}
      </div>
      <BreakLine viewport={viewport} tool={tool} tip={tip} follow={follow} />
    </>
  );
}

/** Insert and holder of the running move, with the chip that it takes. */
export function RunningTool({ viewport, moving }: { readonly viewport: Viewport; readonly moving: Moving }) {
  const { steps, playback } = moving;
  const index = usePlayback(playback, (store) => stepIndex(steps, store.shown()));
  const tip = useMemo(() => () => tipAt(steps, playback.shown()), [steps, playback]);
  const tool = steps[index]?.tool;
  return tool && (
    <Sheet viewport={viewport} tool={tool} tip={tip} follow={playback.subscribe}>
      <ChipSheet viewport={viewport} moving={moving} />
    </Sheet>
  );
}

const NEVER = () => () => undefined;

/** The tool where it stands at the call of the cycle. */
export function WaitingTool({ viewport, tool, at }: { readonly viewport: Viewport; readonly tool: Tool; readonly at: Pt }) {
  const tip = useMemo(() => () => at, [at]);
  return <Sheet viewport={viewport} tool={tool} tip={tip} follow={NEVER} />;
}
