import type { PlanePoint } from "../../kernel/plane/plane.ts";

/** Number format of approaches in the screen language. */
export interface ApproachWords {
  /** A length, at most three decimals. */
  readonly number: (value: number) => string;
  /** Coordinates of a tool centre as the control names them: "X-5 Y-5"; "X⌀40 Z+2" in turning. */
  readonly point: (p: PlanePoint) => string;
  /** The same of a point of the contour. */
  readonly contour: (p: PlanePoint) => string;
}
