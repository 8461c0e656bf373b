import { useEffect, useRef } from "react";
import { sheetShift, type Camera, type Place } from "../../../view/camera.ts";
import { transform } from "../../../view/svg.ts";
import { pageLength } from "../../base/unit.ts";
import type { Viewport } from "./viewport.ts";

const CORNER: Place = { x: 0, y: 0 };

/** Shifts a sheet drawn for one camera to where the picture looks now. `x`, `y`: its corner in the picture. */
export function shiftSheet(
  { style }: ElementCSSInlineStyle,
  viewport: Viewport,
  { x, y } = CORNER,
  drawn = viewport.drawn(),
): void {
  const now = viewport.get();
  if (now === drawn) return void style.removeProperty("transform");
  const shift = sheetShift(drawn, now);
  const right = pageLength(shift.x + x * (shift.grown - 1)),
    down = pageLength(shift.y + y * (shift.grown - 1));
  style.transform = `translate(${right}, ${down}) scale(${shift.grown})`;
}

/**
 * A group in part space that follows the camera by one attribute. `shifts`: the sheet that it is alone on shifts during
 * panning, and is redrawn at rest.
 */
export function World({
  viewport,
  shifts = false,
  children,
}: {
  readonly viewport: Viewport;
  readonly shifts?: boolean;
  readonly children: React.ReactNode;
}) {
  const group = useRef<SVGGElement>(null);
  useEffect(() => {
    let laid: Camera | null = null;
    const follow = () => {
      const element = group.current,
        sheet = element?.ownerSVGElement,
        camera = shifts ? viewport.drawn() : viewport.get();
      if (camera !== laid) {
        element?.setAttribute("transform", transform(camera));
        if (shifts) element?.classList.toggle("coarse", viewport.isCoarse());
      }
      laid = camera;
      if (shifts && sheet) shiftSheet(sheet, viewport);
    };
    follow();
    return viewport.subscribe(follow);
  }, [viewport, shifts]);
  return <g ref={group}>{children}</g>;
}
