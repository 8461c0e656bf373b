import { useEffect, useMemo, useRef } from "react";
import { holderOutlines } from "../../kernel/holder.ts";
import { insertOutline } from "../../kernel/insert.ts";
import type { Pt } from "../../kernel/point.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import type { Tool } from "../../kernel/tool.ts";
import { boundsOf, common, grownBounds, joined } from "../../view/bounds.ts";
import { toScreen, type Bounds } from "../../view/camera.ts";
import { ringData } from "../../view/path.ts";
import { tipAt } from "../../view/tip.ts";
import { stepIndex, type Moving } from "./moving.ts";
import { usePlayback } from "./use-playback.ts";
import type { Viewport } from "./viewport.ts";

/** Pixels round the drawing of a tool for its lines. */
const LINE = 4;
/** As much of a holder is drawn as fits into this many pictures. */
const PICTURES = 1.5;

interface Drawn {
  readonly insert: string;
  readonly holder: string;
  readonly insertBox: Bounds;
  readonly box: Bounds;
}

const drawn = (tool: Tool): Drawn => {
  const insert = insertOutline(tool, CHORD), holder = holderOutlines(tool);
  const insertBox = boundsOf(insert) ?? { left: -1, right: 1, low: -1, high: 1 };
  return { insert: ringData([insert]), holder: ringData(holder), insertBox, box: joined(insertBox, boundsOf(holder.flat())) ?? insertBox };
};

/**
 * A tool on a sheet no larger than itself. The sheet is drawn anew for another tool or another zoom; where the tip goes it follows with one
 * transform, which costs the page no layout and no painting.
 */
function Sheet({ viewport, tool, tip, follow }: {
  readonly viewport: Viewport;
  readonly tool: Tool;
  /** Where the tip stands now; null: nowhere. */
  readonly tip: () => Pt | null;
  /** Calls when the tip has moved; returns what ends it. */
  readonly follow: (listener: () => void) => () => void;
}) {
  const sheet = useRef<SVGSVGElement>(null), world = useRef<SVGGElement>(null);
  const shapes = useMemo(() => drawn(tool), [tool]);
  useEffect(() => {
    const element = sheet.current;
    if (!element) return undefined;
    let corner = { x: 0, y: 0 };
    const place = () => {
      const at = tip();
      if (!at) return;
      const { x, y } = toScreen(viewport.get(), at);
      element.style.transform = `translate(${x + corner.x}px, ${y + corner.y}px)`;
    };
    let scale = 0, up: boolean | null = null;
    const draw = () => {
      const camera = viewport.get(), size = viewport.size();
      if (camera.scale !== scale || camera.xUp !== up) {
        [scale, up] = [camera.scale, camera.xUp];
        const far = (PICTURES * Math.max(size.width, size.height)) / scale;
        const { left, right, low, high } = common(shapes.box, grownBounds(shapes.insertBox, far));
        const top = up ? -high : low;
        corner = { x: left * scale - LINE, y: top * scale - LINE };
        element.setAttribute("width", String(Math.ceil((right - left) * scale + 2 * LINE)));
        element.setAttribute("height", String(Math.ceil((high - low) * scale + 2 * LINE)));
        world.current?.setAttribute("transform", `matrix(${scale} 0 0 ${up ? -scale : scale} ${-corner.x} ${-corner.y})`);
      }
      place();
    };
    draw();
    const ends = [viewport.subscribe(draw), follow(place)];
    return () => ends.forEach((end) => end());
  }, [viewport, shapes, tip, follow]);
  return (
    <svg ref={sheet} className="tool-sheet">
      <g ref={world}>
        {shapes.holder && <path className="shape-holder" d={shapes.holder} />}
        <path className="shape-insert" d={shapes.insert} />
      </g>
    </svg>
  );
}

/** Insert and holder of the running move, at its tip. */
export function RunningTool({ viewport, moving: { steps, playback } }: { readonly viewport: Viewport; readonly moving: Moving }) {
  const index = usePlayback(playback, (store) => stepIndex(steps, store.shown()));
  const tip = useMemo(() => () => tipAt(steps, playback.shown()), [steps, playback]);
  const tool = steps[index]?.tool;
  return tool && <Sheet viewport={viewport} tool={tool} tip={tip} follow={playback.subscribe} />;
}

const NEVER = () => () => undefined;

/** The tool where it stands at the call of the cycle. */
export function WaitingTool({ viewport, tool, at }: { readonly viewport: Viewport; readonly tool: Tool; readonly at: Pt }) {
  const tip = useMemo(() => () => at, [at]);
  return <Sheet viewport={viewport} tool={tool} tip={tip} follow={NEVER} />;
}
