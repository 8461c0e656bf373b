import { memo, useCallback, useEffect, useRef } from "react";
import { transform } from "../../view/svg.ts";
import { planeMotionData } from "../../view/approach/motion-data.ts";
import { spotAt, type PlaneScene, type PlaneShape } from "../../view/approach/plane-scene.ts";
import type { PlaneStep } from "../../program/plane-types.ts";
import type { PlaybackStore } from "../lathe/playback-store.ts";
import { useEachPicture } from "../lathe/use-playback.ts";
import type { Viewport } from "../lathe/viewport.ts";
import { PlaneAxes } from "./PlaneAxes.tsx";

const Still = memo(function Still({ shapes }: { readonly shapes: readonly PlaneShape[] }) {
  return <>{shapes.map(({ role, d }) => <path key={role} className={`plane-${role}`} d={d} />)}</>;
});

/** Follows the camera with one attribute: a group whose content is drawn in the plane. */
function World({ viewport, children }: { readonly viewport: Viewport; readonly children: React.ReactNode }) {
  const group = useRef<SVGGElement>(null);
  useEffect(() => {
    const follow = () => group.current?.setAttribute("transform", transform(viewport.get()));
    follow();
    return viewport.subscribe(follow);
  }, [viewport]);
  return <g ref={group}>{children}</g>;
}

/** The mill from above and the running motion, painted with each picture without rendering. */
function MovingMill({ steps, playback }: { readonly steps: readonly PlaneStep[]; readonly playback: PlaybackStore }) {
  const tool = useRef<SVGGElement>(null), body = useRef<SVGCircleElement>(null), running = useRef<SVGPathElement>(null);
  useEachPicture(playback, useCallback(() => {
    const { step, fraction } = playback.shown(), at = spotAt(steps, step, fraction), motion = steps[Math.min(step, steps.length - 1)];
    tool.current?.setAttribute("visibility", at ? "visible" : "hidden");
    if (!at || !motion) return;
    tool.current?.setAttribute("transform", `translate(${at.x} ${at.y})`);
    body.current?.setAttribute("r", String(motion.radius));
    running.current?.setAttribute("d", planeMotionData(motion));
  }, [steps, playback]));
  return (
    <>
      <path ref={running} className="shape-running" />
      <g ref={tool}>
        <circle ref={body} className="plane-mill" r="0" />
        <path className="plane-mill-centre" d="M-1 0H1M0 -1V1" />
      </g>
    </>
  );
}

/** Contours, path and mill in the working plane. The drawing is painted once; zooming changes one matrix, playing three elements. */
export function PlanePicture({ viewport, scene, steps, playback, name, children }: {
  readonly viewport: Viewport;
  readonly scene: PlaneScene;
  readonly steps: readonly PlaneStep[];
  readonly playback: PlaybackStore;
  readonly name: string;
  /** What stands in screen space above the picture. */
  readonly children: React.ReactNode;
}) {
  return (
    <div className="lathe-picture plane-picture" role="img" aria-label={name}>
      <svg className="sheet">
        <PlaneAxes viewport={viewport} part="grid" />
      </svg>
      <svg className="sheet still">
        <World viewport={viewport}>
          <Still shapes={scene.shapes} />
        </World>
      </svg>
      <svg className="sheet">
        <World viewport={viewport}>
          <MovingMill steps={steps} playback={playback} />
        </World>
        {children}
        <PlaneAxes viewport={viewport} part="scales" />
      </svg>
    </div>
  );
}
