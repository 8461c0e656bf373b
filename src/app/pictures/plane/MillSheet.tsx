import { useEffect, useMemo, useRef } from "react";
import { partPoint } from "../../../kernel/plane/plane.ts";
import type { PlaneStep } from "../../../program/tools/plane-types.ts";
import { spotAt } from "../../../view/approach/plane-scene.ts";
import { pageLength } from "../../base/unit.ts";
import { movingTip } from "../lathe/moving-anchor.ts";
import { TipCarrier } from "../lathe/TipCarrier.tsx";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { usePlayback } from "../lathe/use-playback.ts";
import type { Viewport } from "../lathe/viewport.ts";

/** Margin around the circle for its line, and the arms of the cross in its centre, pixels. */
const LINE = 4,
  CROSS = 6;

/** The shown motion; at the end the last one. */
const shownMotion = (steps: readonly PlaneStep[], playback: PlaybackStore) =>
  steps[Math.min(playback.shown().step, steps.length - 1)];

/** The mill from above on a sheet no larger than itself: redrawn for another radius or zoom, else only moved. */
export function MillSheet({
  viewport,
  steps,
  playback,
}: {
  readonly viewport: Viewport;
  readonly steps: readonly PlaneStep[];
  readonly playback: PlaybackStore;
}) {
  const sheet = useRef<SVGSVGElement>(null),
    body = useRef<SVGCircleElement>(null);
  const radius = usePlayback(playback, () => shownMotion(steps, playback)?.radius ?? null);
  const carrying = useMemo(
    () =>
      movingTip(
        playback,
        ({ step, fraction }) => {
          const at = spotAt(steps, step, fraction);
          return at && partPoint(at);
        },
        (step) => steps[step]?.kind === "arc",
      ),
    [steps, playback],
  );
  useEffect(() => {
    const element = sheet.current;
    if (!element || radius === null) return undefined;
    let drawn = NaN;
    const draw = () => {
      const { scale } = viewport.drawn();
      if (scale === drawn) return;
      drawn = scale;
      const half = Math.ceil(Math.max(radius * scale, CROSS) + LINE);
      element.style.left = element.style.top = pageLength(-half);
      element.style.width = element.style.height = pageLength(2 * half);
      element.setAttribute("viewBox", `${-half} ${-half} ${2 * half} ${2 * half}`);
      body.current?.setAttribute("r", String(radius * scale));
    };
    draw();
    return viewport.subscribe(draw);
  }, [viewport, radius]);
  return (
    radius !== null && (
      <TipCarrier viewport={viewport} carrying={carrying}>
        <svg ref={sheet} className="tool-sheet">
          <circle ref={body} className="plane-mill" r="0" />
          <path className="plane-mill-centre" d={`M${-CROSS} 0H${CROSS}M0 ${-CROSS}V${CROSS}`} />
        </svg>
      </TipCarrier>
    )
  );
}
