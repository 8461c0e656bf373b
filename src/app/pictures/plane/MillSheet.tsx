import { useCallback, useMemo } from "react";
import { partPoint } from "../../../kernel/plane/plane.ts";
import type { PlaneStep } from "../../../program/tools/plane-types.ts";
import { spotAt } from "../../../view/approach/plane-scene.ts";
import { CarriedSheet, LINE } from "../lathe/CarriedSheet.tsx";
import { movingTip } from "../lathe/moving-anchor.ts";
import { TipCarrier } from "../lathe/TipCarrier.tsx";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { usePlayback } from "../lathe/use-playback.ts";
import type { Viewport } from "../lathe/viewport.ts";

/** The arms of the cross in the centre of the circle, pixels. */
const CROSS = 6;

/** The shown motion; at the end the last one. */
const shownMotion = (steps: readonly PlaneStep[], playback: PlaybackStore) =>
  steps[Math.min(playback.shown().step, steps.length - 1)];

/** The mill of the shown motion from above. */
export function MillSheet({
  viewport,
  steps,
  playback,
}: {
  readonly viewport: Viewport;
  readonly steps: readonly PlaneStep[];
  readonly playback: PlaybackStore;
}) {
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
  const boxOf = useCallback(
    (scale: number) => {
      const half = Math.ceil(Math.max((radius ?? 0) * scale, CROSS) + LINE);
      return { left: -half, right: half, low: -half, high: half };
    },
    [radius],
  );
  return (
    radius !== null && (
      <TipCarrier viewport={viewport} carrying={carrying}>
        <CarriedSheet
          viewport={viewport}
          boxOf={boxOf}
          centre={<path className="plane-mill-centre" d={`M${-CROSS} 0H${CROSS}M0 ${-CROSS}V${CROSS}`} />}
        >
          <circle className="plane-mill" r={radius} />
        </CarriedSheet>
      </TipCarrier>
    )
  );
}
