import type { Frame } from "../kernel/geometry/flat.ts";
import type { Issue } from "../kernel/plan/issue.ts";
import type { Plan, Setting } from "../kernel/plan/plan.ts";
import type { Pt, Segment } from "../kernel/geometry/point.ts";
import type { Evidence, Params, Values } from "./params.ts";

/** Groups as the control has them. */
export type Group = "special" | "longitudinal" | "transverse" | "recessTurning" | "recessing" | "thread";

/** What one turns: a step with a shoulder, a plunge behind one, any contour at all, a groove, a thread. */
export type TurnedShape = "step" | "plunge" | "free" | "groove" | "thread";

/** What a cycle is proposed for, when somebody asks which one makes a shape. */
export interface Use {
  /** What it makes. A free contour may be made of a step or a plunge as well. */
  readonly shapes: readonly TurnedShape[];
  /** Its passes follow a blank that has the shape already. */
  readonly preTurned?: true;
}

/** A dimension in the help picture, belonging to one Q. Positions in part space; the view draws arrowheads and text. */
export type Dimension =
  | { readonly q: string; readonly form: "diameter"; readonly at: Pt }
  | { readonly q: string; readonly form: "z" | "r" | "along"; readonly from: Pt; readonly to: Pt }
  | { readonly q: string; readonly form: "angle"; readonly vertex: Pt; readonly from: Pt; readonly to: Pt }
  | { readonly q: string; readonly form: "leader"; readonly at: Pt; readonly towards: Pt };

/** The finished contour that values describe, and the dimension of every parameter that has a place on it. */
export interface Outline {
  readonly contour: readonly Segment[];
  /** How strategy space lies over it, as far as neither tool nor start point decide. */
  readonly frame: Frame;
  /** The tool goes in from the open side, and the part stands beyond both ends of the contour: a groove. */
  readonly sunk: boolean;
  readonly dimensions: readonly Dimension[];
  readonly issues: readonly Issue[];
  /** Of a free contour: where each segment stands in the programmed one, from 1. */
  readonly elements?: readonly number[];
}

/** What a cycle is given beside its values. */
export interface Given {
  /** Of a free-contour cycle: the contour of its subprogram, in programmed order. */
  readonly contour: readonly Segment[] | null;
  /**
   * Theoretical tip at the call: the simple cycles begin there, and a longitudinal contour is cut from its side. Null
   * where it is not known yet.
   */
  readonly start: Pt | null;
}

/** A contour row as it would be typed; missing fields are empty. */
export interface Row {
  readonly kind: "L" | "RND" | "CHF" | "CR";
  readonly x?: string;
  readonly z?: string;
  readonly r?: string;
  readonly turn?: "cw" | "ccw";
}

/**
 * Everything round a cycle that makes its printed example run: ours, since the manual prints only the cycle. mm, X as
 * ⌀.
 */
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
  /**
   * By Q, where the example of a recalled list describes nothing that can be made, or nothing that anybody would make.
   */
  readonly values?: Readonly<Record<string, number>>;
}

/** The contour printed for the transverse free-contour cycle; every cycle offers it where a contour is asked for. */
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

/** The parameters of a thread that a nominal size fills, by Q. */
export interface ThreadRoles {
  /** 0 outside, 1 inside. */
  readonly position: string;
  readonly pitch: string;
  readonly depth: string;
  readonly starts: string;
  /** Angle of infeed. */
  readonly flank: string;
  readonly diameters: readonly string[];
}

/** What is known of a cycle that acts where it is defined. */
export interface Acting {
  /** The parameters that change coordinates, each with the values that leave them as they are. */
  readonly neutral: Readonly<Record<string, readonly number[]>>;
}

/**
 * What a page may print of a cycle beside its list: the name in NC text, what it does, where it starts, how it roughs
 * and finishes.
 */
export type AttestedPart = "name" | "purpose" | "start" | "roughing" | "firstFinishing";

export interface Cycle<P extends Params = Params, N extends number = number> {
  readonly number: N;
  readonly group: Group;
  /** Section and document of the manual page this follows; null where none that we hold prints the cycle. */
  readonly manual: { readonly section: string; readonly document: string; readonly page?: number } | null;
  /** Of a cycle whose list no page prints: what of it a page prints all the same. */
  readonly partly?: { readonly section: string; readonly document: string; readonly parts: readonly AttestedPart[] };
  /** How far the list of its parameters can be trusted. */
  readonly evidence: Evidence;
  /** "own": from its Q values; "free": from a contour subprogram named by cycle 14; "none": it cuts nothing. */
  readonly contour: "own" | "free" | "none";
  /** Of a cycle that acts where it is defined instead of cutting where it is called. */
  readonly acts?: Acting;
  /**
   * Given where it does not follow from group and contour (`useOf` in use.ts): one line, such as `use: { shapes:
   * ["plunge"] }`.
   */
  readonly use?: Use;
  /** In the printed order, which is the order of form and NC text. */
  readonly params: P;
  readonly setup: SetupExample;
  /** Of a cycle that cuts threads. */
  readonly thread?: ThreadRoles;
  /** Steps of the printed sequences, for "step 3 of 6". */
  readonly steps: { readonly rough: number; readonly finish: number };
  /** Pure geometry of the values: contour, help-picture dimensions, and cross-field issues. */
  outline(values: Values<P>, given: Given): Outline;
  /** Values against the tool, and the path. Never throws on values of the right type. */
  plan(values: Values<P>, setting: Setting, given: Given): Plan;
}

/** Keeps the literal types of number and parameters, so that `values.Q493` is a Diameter by inference. */
export const defineCycle = <const P extends Params, const N extends number>(cycle: Cycle<P, N>): Cycle<P, N> => cycle;
