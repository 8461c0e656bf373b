import { useCallback, useRef } from "react";
import type { Step } from "../../../kernel/time/step.ts";
import { stretchData } from "../../../view/path.ts";
import { stepIndex, type PlayedScene } from "../../calculation/moving.ts";
import { useEachPicture } from "./use-playback.ts";

/** The running move, highlighted. */
export function RunningMove({ moving: { steps, playback } }: { readonly moving: PlayedScene }) {
  const running = useRef<SVGPathElement>(null),
    drawn = useRef<Step | null>(null);
  const paint = useCallback(() => {
    const step = steps[stepIndex(steps, playback.shown())];
    if (!step || drawn.current === step) return;
    running.current?.setAttribute("d", stretchData([step]));
    drawn.current = step;
  }, [steps, playback]);
  useEachPicture(playback, paint);
  return <path ref={running} className="shape-running" />;
}
