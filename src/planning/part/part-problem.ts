import type { RowIssue } from "../../program/job/contour-rows.ts";

/** Contours of a part. */
export type PartSide = "outside" | "inside" | "blank";

/** Values of each problem: x (⌀) and z in mm; `at`: place in the file, as `outside.2.x`. */
export interface PartProblemValues {
  readonly notJson: {};
  readonly notPart: {};
  /** The file comes from a newer version. */
  readonly newer: {};
  readonly missing: { readonly at: string };
  readonly unknown: { readonly at: string };
  readonly low: { readonly at: string; readonly limit: number };
  readonly high: { readonly at: string; readonly limit: number };
  readonly wrong: { readonly at: string };
  /** `limit`: characters. */
  readonly tooLong: { readonly limit: number };
  /** Two rows with one id. */
  readonly sameId: { readonly id: string };
  /** A mark for a row that does not exist. */
  readonly noRow: { readonly id: string };
  readonly noOutside: {};
  readonly belowAxis: { readonly x: number; readonly z: number };
  readonly crosses: { readonly x: number; readonly z: number };
  /** Bore and outside do not meet at the front. */
  readonly openFront: { readonly x: number; readonly z: number };
  readonly boreOutside: { readonly x: number; readonly z: number };
  readonly noArea: {};
  /** The front face is not at Z0. */
  readonly front: { readonly z: number };
  readonly threadName: { readonly text: string };
  readonly threadPlace: { readonly text: string };
  /** The cylinder of a thread has neither its nominal nor its crest ⌀. */
  readonly threadSize: { readonly text: string; readonly x: number; readonly crest: number };
  readonly undercutName: { readonly text: string };
  readonly toleranceText: { readonly text: string };
  readonly tolerancePlace: { readonly text: string };
  readonly blankWrong: {};
  /** The finished part is larger than its blank, mm² of the half section. */
  readonly beyondBlank: { readonly area: number };
}
export type PartProblemCode = keyof PartProblemValues;

/** What is wrong with a part: an error leaves no part, a warning leaves one that differs from the drawing. */
export type PartProblem =
  | {
      readonly [C in PartProblemCode]: {
        readonly code: C;
        readonly severity: "error" | "warning";
        readonly values: PartProblemValues[C];
        /** The contour and the id of the row, where it has one. */
        readonly side?: PartSide;
        readonly row?: string;
      };
    }[PartProblemCode]
  | {
      /** An issue of a contour row; its texts are those of the contour table. */
      readonly code: "row";
      readonly severity: "error" | "warning";
      readonly side: PartSide;
      readonly row: string;
      readonly issue: RowIssue["issue"];
    };

/** A problem of a code. */
export const partProblem = <C extends PartProblemCode>(
  code: C,
  values: PartProblemValues[C],
  place: { readonly severity?: "warning"; readonly side?: PartSide; readonly row?: string } = {},
): PartProblem => ({ severity: "error", ...place, code, values }) as PartProblem;
