import type { Frame } from "../kernel/geometry/flat.ts";
import type { Issue } from "../kernel/plan/issue.ts";
import type { Plan, PlanContext } from "../kernel/plan/plan.ts";
import type { Pt, Segment } from "../kernel/geometry/point.ts";
import type { Evidence, Params, Values } from "./params.ts";

/** Cycle groups of the control. */
export type Group = "special" | "longitudinal" | "transverse" | "recessTurning" | "recessing" | "thread";

/** Shapes to turn: a step with a shoulder, a plunge behind one, a free contour, a groove, a thread. */
export type TurnedShape = "step" | "plunge" | "free" | "groove" | "thread";

/** The shapes for which a cycle is proposed. */
export interface Use {
  /** The shapes that it makes. A free contour can also make a step or a plunge. */
  readonly shapes: readonly TurnedShape[];
  /** Its passes follow a blank that already has the shape. */
  readonly preTurned?: true;
}

/** A dimension in the help picture, belonging to one Q. Positions in part space; the view draws arrowheads and text. */
export type Dimension =
  | { readonly q: string; readonly form: "diameter"; readonly at: Pt }
  | { readonly q: string; readonly form: "z" | "r" | "along"; readonly from: Pt; readonly to: Pt }
  | { readonly q: string; readonly form: "angle"; readonly vertex: Pt; readonly from: Pt; readonly to: Pt }
  | { readonly q: string; readonly form: "leader"; readonly at: Pt; readonly towards: Pt };

/** The finished contour of the values, and a dimension for every parameter that has a place on it. */
export interface Outline {
  readonly contour: readonly Segment[];
  /** Orientation of strategy space, as far as it does not depend on tool and start point. */
  readonly frame: Frame;
  /** A groove: the tool goes in from the open side, and the part continues past both ends of the contour. */
  readonly sunk: boolean;
  readonly dimensions: readonly Dimension[];
  readonly issues: readonly Issue[];
  /** For a free contour: index of each segment in the programmed contour, from 1. */
  readonly elements?: readonly number[];
}

/** Inputs of a cycle besides its values. */
export interface Given {
  /** For a free-contour cycle: the contour of its subprogram, in programmed order. */
  readonly contour: readonly Segment[] | null;
  /**
   * Theoretical tip at the call: the simple cycles begin there, and it decides the side of a longitudinal contour. Null
   * while unknown.
   */
  readonly start: Pt | null;
}

/** A contour row as typed; missing fields are empty. */
export interface Row {
  readonly kind: "L" | "RND" | "CHF" | "CR";
  readonly x?: string;
  readonly z?: string;
  readonly r?: string;
  readonly turn?: "cw" | "ccw";
}

/** The set-up in which a cycle's printed example runs: ours, since the manual prints only the cycle. mm, X as ⌀. */
export interface SetupExample {
  /** First part of the program name. */
  readonly name: string;
  /** A shipped tool that can make the contour. */
  readonly tool: number;
  readonly blank: {
    readonly outside: string;
    readonly bore: string;
    readonly length: string;
    readonly allowance: string;
  };
  readonly start: { readonly x: string; readonly z: string };
  readonly contour: readonly Row[];
  /** Other values by Q, where the example of a recalled list makes nothing, or nothing useful. */
  readonly values?: Readonly<Record<string, number>>;
}

/** The contour printed for the transverse free-contour cycle; every free-contour cycle offers it. */
export const printedContour: readonly Row[] = [
  { kind: "L", x: "75", z: "-20" },
  { kind: "L", x: "50" },
  { kind: "RND", r: "2" },
  {
    kind: "L",
    x: "20",
    z: "-25",
  },
  { kind: "RND", r: "2" },
  { kind: "L", z: "0" },
];

/** The parameters that a nominal thread size fills, by Q. */
export interface ThreadRoles {
  /** 0 outside, 1 inside. */
  readonly position: string;
  readonly pitch: string;
  readonly depth: string;
  readonly starts: string;
  /** Angle of infeed. */
  readonly flank: string;
  readonly diameters: readonly string[];
  /** For a line that can be a taper: how it is dimensioned (0: both ends), and the Z of its ends. */
  readonly line?: { readonly form: string; readonly startZ: string; readonly endZ: string };
}

/** A cycle that acts where it is defined. */
export interface Acting {
  /** The parameters that change coordinates, each with the values that leave coordinates unchanged. */
  readonly neutral: Readonly<Record<string, readonly number[]>>;
}

/**
 * Facts of a cycle that a page may print besides its list: the name in NC text, its purpose, where it starts, how it
 * roughs and finishes.
 */
export type PrintedFact = "name" | "purpose" | "start" | "roughing" | "firstFinishing";

export interface Cycle<P extends Params = Params, N extends number = number> {
  readonly number: N;
  readonly group: Group;
  /** Section and document of the manual page; null where no page that we have prints the cycle. */
  readonly manual: { readonly section: string; readonly document: string; readonly page?: number } | null;
  /** For a cycle whose list no page prints: the facts that a page prints nevertheless. */
  readonly partly?: { readonly section: string; readonly document: string; readonly parts: readonly PrintedFact[] };
  /** Evidence for the list of its parameters. */
  readonly evidence: Evidence;
  /** "own": from its Q values; "free": from a contour subprogram named by cycle 14; "none": it cuts nothing. */
  readonly contour: "own" | "free" | "none";
  /** Only for a cycle that acts where it is defined. */
  readonly acts?: Acting;
  /**
   * Given where group and contour do not determine it (`useOf` in use.ts): one line, such as `use: { shapes: ["plunge"]
   * }`.
   */
  readonly use?: Use;
  /** In the printed order, which is the order of form and NC text. */
  readonly params: P;
  readonly setup: SetupExample;
  /** Only for a cycle that cuts threads. */
  readonly thread?: ThreadRoles;
  /** Steps of the printed sequences, for "step 3 of 6". */
  readonly steps: { readonly rough: number; readonly finish: number };
  /** Pure geometry of the values: contour, help-picture dimensions, and cross-field issues. */
  outline(values: Values<P>, given: Given): Outline;
  /** Checks the values against the tool and plans the path. Never throws on values of the right type. */
  plan(values: Values<P>, setting: PlanContext, given: Given): Plan;
}

/** Keeps the literal types of number and parameters, so that `values.Q493` is a Diameter by inference. */
export const defineCycle = <const P extends Params, const N extends number>(cycle: Cycle<P, N>): Cycle<P, N> => cycle;
