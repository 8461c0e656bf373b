import { partPoint } from "../../../kernel/plane/plane.ts";
import { toScreen } from "../../../view/camera.ts";
import type { ApproachWords } from "../../../view/approach/words.ts";
import { px } from "../../../view/help/marks.ts";
import { useCamera } from "../lathe/use-camera.ts";
import type { Viewport } from "../lathe/viewport.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import type { CutPlace } from "./plane-places.ts";

/** Start and end points that the check proposes: a cross in a ring, with coordinates. */
export function FreePoints({
  viewport,
  places,
  speech,
}: {
  readonly viewport: Viewport;
  readonly places: readonly CutPlace[];
  readonly speech: ApproachWords;
}) {
  const t = useTexts().approach,
    camera = useCamera(viewport);
  return (
    <g className="plane-free" aria-hidden="true">
      {places.map(({ id, free }) => {
        if (!free) return null;
        const at = toScreen(camera, partPoint(free.at));
        return (
          <g key={id} transform={`translate(${px(at.x)} ${px(at.y)})`}>
            <circle r="7" />
            <path d="M-11 0H11M0 -11V11" />
            <text x="14" y="-10">
              {t.free} {free.point}
            </text>
            <text className="number" x="14" y="6">
              {speech.point(free.at)}
            </text>
          </g>
        );
      })}
    </g>
  );
}
