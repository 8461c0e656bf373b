import { at } from "../../../kernel/geometry/point.ts";
import { textWidth } from "../../../view/dimensions/labels.ts";
import { toScreen } from "../../../view/camera.ts";
import type { UnstatedClamping } from "../../../view/unstated-clamping.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { SCALE_BELOW, SCALE_LEFT } from "./Axes.tsx";
import { useCamera } from "./use-camera.ts";
import type { Viewport } from "./viewport.ts";

/** Distance of the text from the short lines, and its height, pixels. */
const [GAP, HIGH] = [6, 12];
/** Longest half of the note, as a share of the height of the picture. */
const MOST_OF_HALF = 0.4;

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
    high = viewport.size().height - SCALE_BELOW,
    lowest = high - half;
  const middle = Math.min(y, lowest);
  // Along most of a low picture it would cover what is beside it; the legend says it, too.
  if (half > high * MOST_OF_HALF) return null;
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
