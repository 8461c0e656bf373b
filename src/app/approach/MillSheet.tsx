import { useCallback, useEffect, useRef } from "react";
import { partPoint } from "../../kernel/plane.ts";
import type { PlaneStep } from "../../program/plane-types.ts";
import { toScreen } from "../../view/camera.ts";
import { planeMotionData } from "../../view/approach/motion-data.ts";
import { spotAt } from "../../view/approach/plane-scene.ts";
import type { PlaybackStore } from "../lathe/playback-store.ts";
import { useEachPicture } from "../lathe/use-playback.ts";
import type { Viewport } from "../lathe/viewport.ts";

interface Milling {
  readonly steps: readonly PlaneStep[];
  readonly playback: PlaybackStore;
}

/** Pixels round the circle for its line, and the arms of the cross in its centre. */
const LINE = 4, CROSS = 6;

/**
 * The mill from above on a sheet no larger than itself: drawn anew for another radius or another zoom, else moved by one transform, which
 * costs the page no layout and no painting.
 */
export function MillSheet({ viewport, steps, playback }: Milling & { readonly viewport: Viewport }) {
  const sheet = useRef<SVGSVGElement>(null), body = useRef<SVGCircleElement>(null), cross = useRef<SVGPathElement>(null);
  useEffect(() => {
    const element = sheet.current;
    if (!element) return undefined;
    let drawn = NaN, half = 0;
    const place = () => {
      const { step, fraction } = playback.shown(), at = spotAt(steps, step, fraction), motion = steps[Math.min(step, steps.length - 1)];
      element.style.visibility = at ? "" : "hidden";
      if (!at || !motion) return;
      const camera = viewport.get(), radius = motion.radius * camera.scale;
      if (radius !== drawn) {
        drawn = radius;
        half = Math.ceil(Math.max(radius, CROSS) + LINE);
        element.setAttribute("width", String(2 * half));
        element.setAttribute("height", String(2 * half));
        element.setAttribute("viewBox", `${-half} ${-half} ${2 * half} ${2 * half}`);
        body.current?.setAttribute("r", String(radius));
        cross.current?.setAttribute("d", `M${-CROSS} 0H${CROSS}M0 ${-CROSS}V${CROSS}`);
      }
      const { x, y } = toScreen(camera, partPoint(at));
      element.style.transform = `translate(${x - half}px, ${y - half}px)`;
    };
    place();
    const ends = [viewport.subscribe(place), playback.subscribe(place)];
    return () => ends.forEach((end) => end());
  }, [viewport, steps, playback]);
  return (
    <svg ref={sheet} className="tool-sheet">
      <circle ref={body} className="plane-mill" r="0" />
      <path ref={cross} className="plane-mill-centre" />
    </svg>
  );
}

/** The running motion in its own strength; it changes with the motion, not with the picture. */
export function RunningMotion({ steps, playback }: Milling) {
  const running = useRef<SVGPathElement>(null), drawn = useRef<PlaneStep | null>(null);
  useEachPicture(playback, useCallback(() => {
    const motion = steps[Math.min(playback.shown().step, steps.length - 1)];
    if (!motion || drawn.current === motion) return;
    running.current?.setAttribute("d", planeMotionData(motion));
    drawn.current = motion;
  }, [steps, playback]));
  return <path ref={running} className="shape-running" />;
}
