import { partPoint } from "../../../kernel/plane/plane.ts";
import { toScreen } from "../../../view/camera.ts";
import type { ApproachWords } from "../../../view/approach/words.ts";
import { px } from "../../../view/help/marks.ts";
import type { PicturePlace } from "../lathe/places.ts";
import { useCamera } from "../lathe/use-camera.ts";
import type { Viewport } from "../lathe/viewport.ts";
import { useTexts } from "../../base/settings/use-texts.ts";

/** Start and end points that the check proposes: a cross in a ring, with coordinates. */
export function FreePoints({
  viewport,
  places,
  speech,
}: {
  readonly viewport: Viewport;
  readonly places: readonly PicturePlace[];
  readonly speech: ApproachWords;
}) {
  const t = useTexts().approach,
    camera = useCamera(viewport);
  return (
    <g className="plane-free" aria-hidden="true">
      {places.map(({ id, issue }) => {
        if (issue?.code !== "approachCutsContour" || issue.data.freeY === undefined) return null;
        const { freeX: x, freeY: y, point } = issue.data,
          free = { x, y },
          at = toScreen(camera, partPoint(free));
        return (
          <g key={id} transform={`translate(${px(at.x)} ${px(at.y)})`}>
            <circle r="7" />
            <path d="M-11 0H11M0 -11V11" />
            <text x="14" y="-10">
              {t.free} {point}
            </text>
            <text className="number" x="14" y="6">
              {speech.point(free)}
            </text>
          </g>
        );
      })}
    </g>
  );
}
