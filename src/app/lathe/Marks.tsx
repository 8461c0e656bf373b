import type { Pt } from "../../kernel/point.ts";
import { axial, radius } from "../../kernel/units.ts";
import { toScreen } from "../../view/camera.ts";
import { useCamera } from "./use-camera.ts";
import type { Viewport } from "./viewport.ts";

const ZERO: Pt = { z: axial(0), r: radius(0) };

/** The workpiece zero as quartered circle, and each start point as a cross in a ring. */
export function Marks({ viewport, starts }: { readonly viewport: Viewport; readonly starts: readonly Pt[] }) {
  const camera = useCamera(viewport), zero = toScreen(camera, ZERO);
  return (
    <g aria-hidden="true">
      <g className="lathe-zero" transform={`translate(${zero.x} ${zero.y})`}>
        <circle className="ground" r="7" />
        <path className="quarters" d="M0 0V-7A7 7 0 0 1 7 0ZM0 0V7A7 7 0 0 1 -7 0Z" />
        <circle className="edge" r="7" />
        <path className="edge" d="M-11 0H11M0 -11V11" />
      </g>
      {starts.map((start, i) => {
        const at = toScreen(camera, start);
        return (
          <g key={i} className="lathe-start" transform={`translate(${at.x} ${at.y})`}>
            <circle r="6" />
            <path d="M-10 0H10M0 -10V10" />
          </g>
        );
      })}
    </g>
  );
}
