import { useEffect, useRef } from "react";
import type { Camera } from "../../view/camera.ts";
import { transform } from "../../view/svg.ts";
import type { Viewport } from "./viewport.ts";

/** When the camera has rested so long, a drawing that only followed it as a picture is drawn anew, ms. */
const RESTS = 140;

/** A drawn sheet as it lies under another camera: moved and stretched, not drawn anew. */
function shifted(drawn: Camera, now: Camera): string {
  const by = now.scale / drawn.scale;
  return `translate(${now.zero.x - drawn.zero.x * by}px, ${now.zero.y - drawn.zero.y * by}px) scale(${by})`;
}

/**
 * Follows the camera with one attribute: a group whose content is drawn in part space. A long drawing takes longer than a picture may:
 * while a hand moves it, its sheet is only shifted, and drawn anew when the hand rests.
 */
export function World({ viewport, isLong = false, children }: { readonly viewport: Viewport; readonly isLong?: boolean;
  readonly children: React.ReactNode })
{
  const group = useRef<SVGGElement>(null);
  useEffect(() => {
    let drawn: Camera | null = null, rest: ReturnType<typeof setTimeout> | undefined;
    const draw = () => {
      const element = group.current;
      drawn = viewport.get();
      element?.setAttribute("transform", transform(drawn));
      element?.ownerSVGElement?.style.removeProperty("transform");
    };
    const follow = () => {
      const now = viewport.get(), sheet = group.current?.ownerSVGElement;
      clearTimeout(rest);
      if (!isLong || !sheet || !drawn || drawn.xUp !== now.xUp) return draw();
      sheet.style.transform = shifted(drawn, now);
      rest = setTimeout(draw, RESTS);
    };
    draw();
    const stop = viewport.subscribe(follow);
    return () => {
      clearTimeout(rest);
      stop();
    };
  }, [viewport, isLong]);
  return <g ref={group}>{children}</g>;
}
