import { memo, useMemo, useSyncExternalStore } from "react";
import type { ApproachRun } from "../../../program/tools/plane-types.ts";
import { onScreen } from "../../../view/approach/frame.ts";
import { contactLines } from "../../../view/approach/points.ts";
import { planeNames } from "../../../view/approach/plane-names.ts";
import type { Camera } from "../../../view/camera.ts";
import type { ApproachWords } from "../../../view/approach/words.ts";
import { polyline, px, type Mark } from "../../../view/help/marks.ts";
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

/** The shown points of an approach: its contact is a point of the contour for a mill. */
const pointsOf = ({ points, departing, plane, request: { element } }: ApproachRun) => ({
  points,
  departing,
  contact: plane === "XY" ? (departing ? element.to : element.from) : null,
});

/**
 * PS, PH, PA, PE and PN of approaches and departures, with coordinates where there is room; PA and PE of a mill on the
 * contour, joined to the tool centre there. While panning each label moves with its point; at rest they are placed
 * again.
 */
export function PlanePoints({
  viewport,
  approaches,
  isNamed,
  speech,
  id,
  choose,
}: {
  readonly viewport: Viewport;
  readonly approaches: readonly ApproachRun[];
  /** Whose points have names; the others have only dots. */
  readonly isNamed: (approach: ApproachRun) => boolean;
  readonly speech: ApproachWords;
  readonly id: string;
  /** Leaves out some for a view. */
  readonly choose?: (approaches: readonly ApproachRun[], camera: Camera) => readonly ApproachRun[];
}) {
  const camera = useCamera(viewport),
    drawn = useSyncExternalStore(viewport.subscribe, viewport.drawn),
    size = viewport.size();
  const shown = useMemo(
    () => (choose ? choose(approaches, drawn) : approaches).map((a) => ({ ...pointsOf(a), isNamed: isNamed(a) })),
    [choose, approaches, isNamed, drawn],
  );
  const names = useMemo(() => planeNames(shown, drawn, size, speech), [shown, drawn, size, speech]);
  return (
    <g className="plane-points" aria-hidden="true">
      <path className="approach-contact" d={contactLines(shown, camera).map(polyline).join("")} />
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
