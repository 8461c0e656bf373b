import { at } from "../../../kernel/geometry/point.ts";
import { toScreen } from "../../../view/camera.ts";
import type { HeldPlane } from "../../../view/held-plane.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { SCALE_LEFT } from "./Axes.tsx";
import { useCamera } from "./use-camera.ts";
import type { Viewport } from "./viewport.ts";

/** From the short lines to the text, and the height of a text, pixels. */
const [GAP, HIGH] = [6, 12];

/** Beside the plane at the rear end: that nothing is stated of what holds the work. */
export function HeldNote({
  viewport,
  plane: {
    plane: [, top],
    hatch,
  },
}: {
  readonly viewport: Viewport;
  readonly plane: HeldPlane;
}) {
  const { note } = useTexts().lathe.held,
    camera = useCamera(viewport);
  const left = Math.min(...hatch.flat().map(({ z }) => z));
  const { x, y } = toScreen(camera, at(left, 0));
  const place = Math.max(SCALE_LEFT + HIGH, x - GAP);
  // A text that would stand on the work itself says nothing of its end.
  if (place > toScreen(camera, top).x) return null;
  return (
    <text
      className="lathe-held-note"
      aria-hidden="true"
      textAnchor="middle"
      transform={`translate(${place} ${y}) rotate(-90)`}
    >
      {note}
    </text>
  );
}
