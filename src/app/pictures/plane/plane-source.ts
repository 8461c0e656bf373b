import { partPoint, partSegment } from "../../../kernel/plane/plane.ts";
import type { Ring } from "../../../kernel/geometry/point.ts";
import type { Run } from "../../../program/state/run-types.ts";
import { standingAbove } from "../../../sim/plane/body.ts";
import { milledFingerprints } from "../../../view/measure/stock-fingerprint.ts";
import type { MeasurableRun } from "../measure/source.ts";

/** The outline of the blank, seen from above. */
const groundOf = ({ cuboid, blank }: Run): readonly Ring[] =>
  standingAbove({ block: cuboid, turned: cuboid ? null : blank }, -Infinity);

/**
 * Measurable content of a milling run, without the stock of a moment: contours of approaches, and the ends of its
 * motions.
 */
export const measurablePlane = (run: Run): MeasurableRun => ({
  plane: "XY",
  contours: run.approaches.filter((each) => each.plane === "XY").map(({ contour }) => contour.map(partSegment)),
  blank: groundOf(run),
  path: () => run.plane.map(({ to }) => partPoint(to)),
  fingerprintOf: milledFingerprints([...run.blank, ...groundOf(run)], run.plane, run),
});
