import type { ShownPoint } from "../../../view/approach/points.ts";
import { px } from "../../../view/help/marks.ts";

/** A point of an approach: a full dot on the contour, a ring on the path of the tool. */
export function PointDot({
  x,
  y,
  onContour,
  quiet = false,
}: {
  readonly x: number;
  readonly y: number;
  readonly onContour: boolean;
  /** Of another block than the chosen one. */
  readonly quiet?: boolean;
}) {
  const kind = quiet ? "quiet" : onContour ? "on-contour" : "on-path";
  return <circle className={`approach-point ${kind}`} cx={px(x)} cy={px(y)} r={quiet ? 1.75 : 3.5} />;
}

/** Points on the contour lie over those of the tool that touches it. */
export const contourLast = <P extends Pick<ShownPoint, "onContour">>(points: readonly P[]): readonly P[] =>
  points.toSorted((a, b) => Number(a.onContour) - Number(b.onContour));

/** The points of a drawing. */
export const PointDots = ({ points }: { readonly points: readonly ShownPoint[] }) =>
  contourLast(points).map(({ at, place, onContour }) => (
    <PointDot key={`${at.x} ${at.y}`} {...place} onContour={onContour} />
  ));
