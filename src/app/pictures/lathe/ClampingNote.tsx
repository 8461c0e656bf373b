import { at } from "../../../kernel/geometry/point.ts";
import { textWidth } from "../../../view/help/labels.ts";
import { toScreen } from "../../../view/camera.ts";
import type { UnstatedClamping } from "../../../view/unstated-clamping.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { SCALE_BELOW, SCALE_LEFT } from "./Axes.tsx";
import { useCamera } from "./use-camera.ts";
import type { Viewport } from "./viewport.ts";

/** Distance of the text from the short lines, and its height, pixels. */
const [GAP, HIGH] = [6, 12];

/** Note at the plane of the rear end that the clamping is not stated. */
export function ClampingNote({
  viewport,
  plane: {
    plane: [, top],
    hatch,
  },
}: {
  readonly viewport: Viewport;
  readonly plane: UnstatedClamping;
}) {
  const { note } = useTexts().lathe.held,
    camera = useCamera(viewport);
  const left = Math.min(...hatch.flat().map(({ z }) => z));
  const { x, y } = toScreen(camera, at(left, 0));
  const place = Math.max(SCALE_LEFT + HIGH, x - GAP);
  // A text over the workpiece would not refer to its end, and one longer than the picture would be cut.
  const half = textWidth(note, HIGH) / 2,
    lowest = viewport.size().height - SCALE_BELOW - half;
  const middle = Math.min(y, lowest);
  if (place > toScreen(camera, top).x || middle < half) return null;
  return (
    <text
      className="lathe-held-note"
      aria-hidden="true"
      textAnchor="middle"
      transform={`translate(${place} ${middle}) rotate(-90)`}
    >
      {note}
    </text>
  );
}
