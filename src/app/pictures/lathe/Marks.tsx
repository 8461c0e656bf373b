import { useMemo } from "react";
import type { Pt } from "../../../kernel/geometry/point.ts";
import { toScreen, type Camera, type Place } from "../../../view/camera.ts";
import { WORKPIECE_ZERO } from "../../../view/datum.ts";
import { useCamera } from "./use-camera.ts";
import type { Viewport } from "./viewport.ts";

/** The point that dimensions count from, as a quartered circle. */
export function ZeroMark({ at }: { readonly at: Place }) {
  return (
    <g className="lathe-zero" aria-hidden="true" transform={`translate(${at.x} ${at.y})`}>
      <circle className="ground" r="7" />
      <path className="quarters" d="M0 0V-7A7 7 0 0 1 7 0ZM0 0V7A7 7 0 0 1 -7 0Z" />
      <circle className="edge" r="7" />
      <path className="edge" d="M-11 0H11M0 -11V11" />
    </g>
  );
}

const tenths = (pixels: number) => Math.round(10 * pixels) / 10;

/** A cross in a ring, pixels. */
const startAt = ({ x, y }: Place): string =>
  `M${x - 6} ${y}a6 6 0 1 1 12 0a6 6 0 1 1 -12 0M${x - 10} ${y}h20M${x} ${y - 10}v20`;

/** All start points as one path, relative to the zero point, so that panning leaves it unchanged. */
function Starts({ camera, starts }: { readonly camera: Camera; readonly starts: readonly Pt[] }) {
  const { scale, xUp, zero } = camera;
  const lines = useMemo(() => {
    const places = starts.map((start) => toScreen({ scale, xUp, zero: { x: 0, y: 0 } }, start));
    return [...new Set(places.map(({ x, y }) => startAt({ x: tenths(x), y: tenths(y) })))].join("");
  }, [scale, xUp, starts]);
  return (
    <g
      className={starts.length > 1 ? "lathe-start of-many" : "lathe-start"}
      transform={`translate(${zero.x} ${zero.y})`}
    >
      <path d={lines} />
    </g>
  );
}

/**
 * The active datum as a quartered circle, the workpiece zero as a thin ring if it differs, and each start point as a
 * cross in a ring. The name of the picture says the same in words.
 */
export function Marks({
  viewport,
  starts,
  datum,
}: {
  readonly viewport: Viewport;
  readonly starts: readonly Pt[];
  readonly datum: Pt;
}) {
  const camera = useCamera(viewport),
    zero = toScreen(camera, datum),
    work = toScreen(camera, WORKPIECE_ZERO);
  return (
    <g aria-hidden="true">
      {(datum.z !== 0 || datum.r !== 0) && (
        <g className="lathe-zero" transform={`translate(${work.x} ${work.y})`}>
          <circle className="edge" r="4" />
        </g>
      )}
      <ZeroMark at={zero} />
      <Starts camera={camera} starts={starts} />
    </g>
  );
}
