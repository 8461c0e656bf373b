import { useEffect, useMemo, useRef } from "react";
import type { PlaneStep } from "../../../program/tools/plane-types.ts";
import type { PlayPosition } from "../../../sim/simulation.ts";
import { depthStrip, stripAt } from "../../../view/approach/depth.ts";
import { directionChanges } from "../../../view/direction-changes.ts";
import { glide, type GlideWay } from "../../calculation/glide.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { JERKS } from "../lathe/Timeline.tsx";
import { useLengths } from "../../calculation/lengths.ts";
import { useTexts } from "../../base/settings/use-texts.ts";

/** The height of the tool over its path, with the running moment. */
export function DepthPicture({
  steps,
  playback,
}: {
  readonly steps: readonly PlaneStep[];
  readonly playback: PlaybackStore;
}) {
  const t = useTexts().approach,
    lengths = useLengths();
  const strip = useMemo(() => depthStrip(steps), [steps]);
  const head = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (!strip || !head.current) return undefined;
    const at = ({ step, fraction }: PlayPosition) => `translateX(${stripAt(strip, step, fraction) * 100}%)`;
    const bends: GlideWay["bends"] = (track, between, fine) => directionChanges(track, between, fine, () => false);
    return glide(head.current, playback, { at, bends, jerks: JERKS }).end;
  }, [strip, playback]);
  if (!strip) return null;
  const [high, low] = [lengths.signed(strip.high), lengths.signed(strip.low)];
  return (
    <div className="plane-depth" role="img" aria-label={t.depthStrip(low, high)}>
      <span className="plane-depth-name small soft">Z</span>
      <span className="plane-depth-scale number" aria-hidden="true">
        <span>{high}</span>
        <span>{low}</span>
      </span>
      <div className="plane-depth-box">
        <svg viewBox="-0.002 -0.06 1.004 1.12" preserveAspectRatio="none" aria-hidden="true">
          {strip.zero !== null && <path className="lathe-axis" d={`M0 ${strip.zero}H1`} />}
          <path className="plane-feed" d={strip.feed} />
          <path className="plane-rapid" d={strip.rapid} />
        </svg>
        <div ref={head} className="lathe-playhead" />
      </div>
    </div>
  );
}
