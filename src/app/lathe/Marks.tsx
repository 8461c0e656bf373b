import type { Pt } from "../../kernel/point.ts";
import { toScreen, type Place } from "../../view/camera.ts";
import { WORKPIECE_ZERO } from "../../view/datum.ts";
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

/**
 * The point that the program counts from as quartered circle, the workpiece zero as a thin ring when that is another one, and each
 * start point as a cross in a ring. What they say is in the name of the picture.
 */
export function Marks({ viewport, starts, datum }: { readonly viewport: Viewport; readonly starts: readonly Pt[]; readonly datum: Pt }) {
  const camera = useCamera(viewport), zero = toScreen(camera, datum), work = toScreen(camera, WORKPIECE_ZERO);
  return (
    <g aria-hidden="true">
      {(datum.z !== 0 || datum.r !== 0) && (
        <g className="lathe-zero" transform={`translate(${work.x} ${work.y})`}>
          <circle className="edge" r="4" />
        </g>
      )}
      <ZeroMark at={zero} />
      {starts.map((start, i) => {
        const at = toScreen(camera, start);
        return (
          <g key={i} className={starts.length > 1 ? "lathe-start of-many" : "lathe-start"} transform={`translate(${at.x} ${at.y})`}>
            <circle r="6" />
            <path d="M-10 0H10M0 -10V10" />
          </g>
        );
      })}
    </g>
  );
}
