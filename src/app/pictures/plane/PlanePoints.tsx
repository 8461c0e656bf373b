import { memo, useMemo, useSyncExternalStore } from "react";
import type { ApproachRun } from "../../../program/tools/plane-types.ts";
import { onScreen } from "../../../view/approach/frame.ts";
import { planeNames } from "../../../view/approach/plane-names.ts";
import type { Camera } from "../../../view/camera.ts";
import type { ApproachWords } from "../../../view/approach/words.ts";
import { px, type Mark } from "../../../view/help/marks.ts";
import { HelpMarks } from "../help/HelpMarks.tsx";
import { useCamera } from "../lathe/use-camera.ts";
import type { Viewport } from "../lathe/viewport.ts";

const Names = memo(function Names({
  x,
  y,
  marks,
  id,
}: {
  readonly x: number;
  readonly y: number;
  readonly marks: readonly Mark[];
  readonly id: string;
}) {
  return (
    <>
      <circle className="approach-point" cx={px(x)} cy={px(y)} r={3.5} />
      <HelpMarks marks={marks} id={id} />
    </>
  );
});

/**
 * PS, PH, PA, PE and PN of approaches and departures, with coordinates where there is room. While panning each label
 * moves with its point; at rest they are placed again.
 */
export function PlanePoints({
  viewport,
  approaches,
  speech,
  id,
  choose,
}: {
  readonly viewport: Viewport;
  readonly approaches: readonly ApproachRun[];
  readonly speech: ApproachWords;
  readonly id: string;
  /** Leaves out some for a view. */
  readonly choose?: (approaches: readonly ApproachRun[], camera: Camera) => readonly ApproachRun[];
}) {
  const camera = useCamera(viewport),
    drawn = useSyncExternalStore(viewport.subscribe, viewport.drawn),
    size = viewport.size();
  const names = useMemo(
    () => planeNames(choose ? choose(approaches, drawn) : approaches, drawn, size, speech),
    [choose, approaches, drawn, size, speech],
  );
  return (
    <g className="plane-points" aria-hidden="true">
      {names.map(({ at, place, marks }, i) => {
        const now = onScreen(camera, at);
        return (
          <g key={i} transform={`translate(${px(now.x - place.x)} ${px(now.y - place.y)})`}>
            <Names x={place.x} y={place.y} marks={marks} id={id} />
          </g>
        );
      })}
    </g>
  );
}
