import { memo, useMemo, useSyncExternalStore } from "react";
import type { ApproachRun } from "../../../program/tools/plane-types.ts";
import { onScreen } from "../../../view/approach/frame.ts";
import { contactLines } from "../../../view/approach/points.ts";
import { planeNames, type NamedPlace } from "../../../view/approach/plane-names.ts";
import { toScreen, type Camera } from "../../../view/camera.ts";
import type { ApproachWords } from "../../../view/approach/words.ts";
import { polyline, px } from "../../../view/help/marks.ts";
import { HelpMarks } from "../help/HelpMarks.tsx";
import { badgeAreas } from "../lathe/PlaceButtons.tsx";
import { sectionProjection } from "../lathe/place-projection.ts";
import type { PicturePlace } from "../lathe/places.ts";
import { useCamera } from "../lathe/use-camera.ts";
import type { Viewport } from "../lathe/viewport.ts";
import { contourLast, PointDot } from "./PointDot.tsx";

const Names = memo(function Names({
  x,
  y,
  onContour,
  isNamed,
  marks,
  id,
}: Pick<NamedPlace, "onContour" | "isNamed" | "marks"> & {
  readonly x: number;
  readonly y: number;
  readonly id: string;
}) {
  return (
    <>
      <PointDot x={x} y={y} onContour={onContour} quiet={!isNamed} />
      <HelpMarks marks={marks} id={id} />
    </>
  );
});

/** The shown points of an approach; its contact is the programmed point of the contour. */
const pointsOf = ({ points, departing, plane, request: { element, toolRadius } }: ApproachRun) => ({
  points,
  departing,
  ...(plane === "XY" && { toolRadius }),
  contact: departing ? element.to : element.from,
});

/**
 * PS, PH, PA, PE and PN of approaches and departures, with coordinates where there is room; PA and PE on the contour,
 * joined to the point of the tool there. While panning each label moves with its point; at rest they are placed again.
 */
export function PlanePoints({
  viewport,
  approaches,
  isNamed,
  speech,
  places,
  id,
  choose,
}: {
  readonly viewport: Viewport;
  readonly approaches: readonly ApproachRun[];
  /** Whose points have names; the others have only dots. */
  readonly isNamed: (approach: ApproachRun) => boolean;
  readonly speech: ApproachWords;
  /** Places whose marks no name covers. */
  readonly places: readonly PicturePlace[];
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
  const names = useMemo(() => {
    const taken = badgeAreas(places, { ...sectionProjection(viewport), at: (place) => toScreen(drawn, place) });
    return contourLast(planeNames(shown, drawn, size, speech, taken));
  }, [shown, drawn, size, speech, places, viewport]);
  return (
    <g className="plane-points" aria-hidden="true">
      <path className="approach-contact" d={contactLines(shown, camera).map(polyline).join("")} />
      {names.map(({ at, place, ...shown }, i) => {
        const now = onScreen(camera, at);
        return (
          <g key={i} transform={`translate(${px(now.x - place.x)} ${px(now.y - place.y)})`}>
            <Names x={place.x} y={place.y} {...{ ...shown, id }} />
          </g>
        );
      })}
    </g>
  );
}
