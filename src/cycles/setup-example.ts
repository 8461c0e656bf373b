import type { CycleNumber } from "./index.ts";

/** A contour row as it would be typed; missing fields are empty. */
interface Row {
  readonly kind: "L" | "RND" | "CHF" | "CR";
  readonly x?: string;
  readonly z?: string;
  readonly r?: string;
  readonly turn?: "cw" | "ccw";
}

/** Everything round a cycle that makes its printed example run: ours, since the manual prints only the cycle. mm, X as ⌀. */
export interface SetupExample {
  /** First part of the program name. */
  readonly name: string;
  /** A shipped tool that can make the contour. */
  readonly tool: number;
  readonly blank: { readonly outside: string; readonly bore: string; readonly length: string; readonly allowance: string };
  readonly start: { readonly x: string; readonly z: string };
  readonly contour: readonly Row[];
}

const start = { x: "75", z: "2" };
/** The contour printed for the transverse free-contour cycle. */
const printedContour: readonly Row[] = [
  { kind: "L", x: "75", z: "-20" }, { kind: "L", x: "50" }, { kind: "RND", r: "2" },
  { kind: "L", x: "20", z: "-25" }, { kind: "RND", r: "2" }, { kind: "L", z: "0" },
];

const examples: Readonly<Record<CycleNumber, SetupExample>> = {
  812: { name: "SHOULDER", tool: 1, blank: { outside: "75", bore: "", length: "100", allowance: "0" }, start, contour: printedContour },
  820: { name: "CONTOUR", tool: 15, blank: { outside: "75", bore: "", length: "80", allowance: "0" }, start, contour: printedContour },
  // The groove is printed 20 mm behind Z0, and its tool is 35 mm long: the face of this blank stands where the groove starts.
  852: { name: "GROOVE", tool: 8, blank: { outside: "90", bore: "", length: "60", allowance: "-20" }, start, contour: printedContour },
};

/** The set-up of a cycle's printed example. */
export const setupExample = (cycle: number): SetupExample =>
  examples[cycle as CycleNumber] ?? { name: "PART", tool: 1, blank: { outside: "75", bore: "", length: "100", allowance: "0" }, start, contour: printedContour };
