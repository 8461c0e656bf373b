import type { Pt } from "../kernel/geometry/point.ts";
import { axial, radius } from "../kernel/units.ts";

/** A change of the point that a program counts from: from which step on, and where it lies on the workpiece. */
export interface DatumMark {
  readonly step: number;
  readonly at: Pt;
}

export const WORKPIECE_ZERO: Pt = { z: axial(0), r: radius(0) };

/** Which of the changes holds at a step, at the number of steps behind the last one; -1 before the first. */
export const datumIndex = (marks: readonly DatumMark[], step: number): number =>
  marks.findLastIndex((m) => m.step <= step);

/** Where the program counts from when change `index` holds. */
export const datumAt = (marks: readonly DatumMark[], index: number): Pt => marks[index]?.at ?? WORKPIECE_ZERO;
