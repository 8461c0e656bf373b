import { useCallback, useMemo, useRef } from "react";
import { holderOutlines } from "../../kernel/holder.ts";
import { insertOutline } from "../../kernel/insert.ts";
import type { Pt, Ring } from "../../kernel/point.ts";
import type { Step } from "../../kernel/step.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import { radius } from "../../kernel/units.ts";
import type { Tool } from "../../kernel/tool.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import { ringData, stretchData } from "../../view/path.ts";
import { tipAt } from "../../view/tip.ts";
import type { PlaybackStore } from "./playback-store.ts";
import { useEachPicture, usePlayback } from "./use-playback.ts";

/** What moves in the picture: a run on a playback, and the stock at any position of it. */
export interface Moving {
  readonly steps: readonly Step[];
  readonly stockAt: (position: PlayPosition) => readonly Ring[];
  readonly playback: PlaybackStore;
}

/** What stands there before anything moves. */
export interface Waiting {
  readonly blank: readonly Ring[];
  readonly tool: Tool | null;
  readonly start: Pt | null;
}

const farSide = (rings: readonly Ring[]): Ring[] => rings.map((ring) => ring.map((p) => ({ z: p.z, r: radius(-p.r) })));

/** The remaining material, painted with each picture without rendering. */
function Stock({ moving: { stockAt, playback }, full, fill }: { readonly moving: Moving; readonly full: boolean; readonly fill: string }) {
  const path = useRef<SVGPathElement>(null);
  const paint = useCallback(() => {
    const rings = stockAt(playback.shown());
    path.current?.setAttribute("d", ringData(full ? [...rings, ...farSide(rings)] : rings));
  }, [stockAt, playback, full]);
  useEachPicture(playback, paint);
  return <path ref={path} className="shape-stock" style={{ fill }} fillRule="evenodd" />;
}

/** The step that runs at a position; the last one at the end. */
const stepIndex = (steps: readonly Step[], position: PlayPosition) => Math.min(position.step, steps.length - 1);

function Insert({ tool }: { readonly tool: Tool }) {
  const shapes = useMemo(() => ({ insert: ringData([insertOutline(tool, CHORD)]), holder: ringData(holderOutlines(tool)) }), [tool]);
  return (
    <>
      {shapes.holder && <path className="shape-holder" d={shapes.holder} />}
      <path className="shape-insert" d={shapes.insert} />
    </>
  );
}

/** Insert and holder at the tip, and the running move in its own strength. */
function Running({ moving: { steps, playback } }: { readonly moving: Moving }) {
  const group = useRef<SVGGElement>(null), running = useRef<SVGPathElement>(null);
  const drawn = useRef<Step | null>(null);
  const index = usePlayback(playback, (store) => stepIndex(steps, store.shown()));
  const paint = useCallback(() => {
    const position = playback.shown(), tip = tipAt(steps, position), step = steps[stepIndex(steps, position)];
    if (tip) group.current?.setAttribute("transform", `translate(${tip.z} ${tip.r})`);
    if (step && drawn.current !== step) {
      running.current?.setAttribute("d", stretchData([step]));
      drawn.current = step;
    }
  }, [steps, playback]);
  useEachPicture(playback, () => paint());
  const tool = steps[index]?.tool;
  return (
    <>
      <path ref={running} className="shape-running" />
      <g ref={group}>{tool && <Insert tool={tool} />}</g>
    </>
  );
}

/** The tool where it stands at the call of the cycle. */
const Still = ({ tool, at }: { readonly tool: Tool; readonly at: Pt }) => (
  <g transform={`translate(${at.z} ${at.r})`}>
    <Insert tool={tool} />
  </g>
);

export const MovingParts = { Stock, Tool: Running, Still };
