import type { Approach } from "../../kernel/plane/approach.ts";
import { partPoint, plane, type PlanePoint, type PlaneSegment } from "../../kernel/plane/plane.ts";
import { boundsOf } from "../bounds.ts";
import { fitted, toScreen, type Bounds, type Camera, type Margin, type Place, type Size } from "../camera.ts";

const { apart, beyond, direction, lengthOf, pointOn } = plane;

/** A point of the working plane on the screen: its first axis to the right, its second upwards. */
export const onScreen = (camera: Camera, p: PlanePoint): Place => toScreen(camera, partPoint(p));

/** Points along segments, close enough to frame them and to keep texts off them. */
export function* along(segments: Iterable<PlaneSegment>, parts: number): Generator<PlanePoint> {
  for (const s of segments) for (let i = 0; i <= parts; i += 1) yield pointOn(s, i / parts);
}

/** The contour's piece nearest to the tool's way, in its own direction: as long as the way itself. */
export function nearPiece(element: PlaneSegment, departing: boolean, reach: number): PlaneSegment {
  const long = lengthOf(element);
  if (long <= reach) return element;
  if (element.kind === "line") {
    const way = direction(element, element.from);
    return departing
      ? { ...element, from: beyond(element.to, way, -reach) }
      : { ...element, to: beyond(element.from, way, reach) };
  }
  const at = pointOn(element, departing ? 1 - reach / long : reach / long);
  return plane.along(element, at) > 0 ? (departing ? { ...element, from: at } : { ...element, to: at }) : element;
}

/** The box round an approach: its points with the whole tool, its path, and as much of the contour as that. */
export function planeFrameOf(result: Approach, element: PlaneSegment, toolRadius: number): Bounds {
  const points = Object.values(result.points);
  const [first] = points;
  const extent = first ? Math.max(...points.map((p) => apart(p, first))) : 0;
  const reach = Math.max(extent * 0.8, toolRadius * 1.5, 2);
  const round = points.flatMap((p) => [
    { x: p.x - toolRadius, y: p.y - toolRadius },
    { x: p.x + toolRadius, y: p.y + toolRadius },
  ]);
  const all = [
    ...round,
    ...along(
      result.legs.map((leg) => leg.segment),
      24,
    ),
    ...along([nearPiece(element, result.departing, reach)], 8),
  ];
  return boundsOf(all.map(partPoint)) ?? { left: -10, right: 10, low: -10, high: 10 };
}

/** The camera for a picture of an approach. */
export const cameraFor = (bounds: Bounds, size: Size, margin: Margin): Camera => fitted(bounds, size, margin, true);
