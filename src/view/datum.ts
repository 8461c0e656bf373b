import type { Pt } from "../kernel/geometry/point.ts";
import { axial, radius } from "../kernel/units.ts";

/** A change of the datum: the step from which it applies, and the place of the datum on the workpiece. */
export interface DatumMark {
  readonly step: number;
  readonly at: Pt;
}

export const WORKPIECE_ZERO: Pt = { z: axial(0), r: radius(0) };

/** Index of the change that applies at a step (the number of steps stands for the end); -1 before the first change. */
export const datumIndex = (marks: readonly DatumMark[], step: number): number =>
  marks.findLastIndex((m) => m.step <= step);

/** The datum while change `index` applies. */
export const datumAt = (marks: readonly DatumMark[], index: number): Pt => marks[index]?.at ?? WORKPIECE_ZERO;
