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
