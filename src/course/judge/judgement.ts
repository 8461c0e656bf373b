import type { Reason } from "../../kernel/plan/issue.ts";
import type { Pt, Ring } from "../../kernel/geometry/point.ts";
import type { Run, RunFinding } from "../../program/state/run-types.ts";
import type { Simulation } from "../../sim/simulation.ts";

/**
 * The rules of a judgement. The first ones always apply; "missing" and "residue" compare the made part with the target
 * part; the others are rules of a task under the same names.
 */
export const RULES = [
  "errors",
  "unproved",
  "blank",
  "rapid",
  "holder",
  "gouge",
  "missing",
  "residue",
  "size",
  "clean",
  "depth",
  "speed",
  "tools",
  "mostTools",
  "seconds",
  "cycles",
  "without",
  "values",
  "passes",
  "rz",
  "words",
] as const;
export type RuleName = (typeof RULES)[number];

/** The learner's program with its run and its simulation. */
export interface Answer {
  readonly text: string;
  readonly run: Run;
  readonly simulation: Simulation;
}

/** One value of a slip: `q` is a parameter or the axis of a path ("X"), `better` the value without the slip. */
export interface SlipValue {
  readonly block: number;
  readonly q: string;
  readonly value: number;
  readonly better: number;
}

/**
 * A slip that explains a fault: a wrong sign, a radius for a diameter or the reverse, two exchanged values, a misplaced
 * decimal point, an end on the wrong side of the start or counted from it, a contour in the wrong direction (`values`: its first block), two exchanged blocks (`values`: these), a
 * cycle that is not called (`values`: its definition and number), two exchanged tools, or one tool for another (`q`: "T").
 */
export interface Slip {
  readonly kind:
    | "sign"
    | "radius"
    | "doubled"
    | "exchanged"
    | "point"
    | "side"
    | "relative"
    | "reversed"
    | "order"
    | "call"
    | "tools"
    | "tool";
  readonly values: readonly SlipValue[];
}

/** The result of one check. Lengths mm, areas mm² of the half section, Rz µm, times s. */
export interface TaskMark {
  readonly rule: RuleName;
  readonly passed: boolean;
  /** Measured value, and its limit. */
  readonly value?: number;
  readonly limit?: number;
  /** Number of the block to blame or to change; step of the run, from 0; cycle call, from 0. */
  readonly block?: number;
  readonly step?: number;
  readonly operation?: number;
  /** The parameter concerned: "Q463". */
  readonly q?: string;
  /** A point inside the marked region, and the region itself. */
  readonly place?: Pt;
  readonly rings?: readonly Ring[];
  /** Index into `Task.sizes`, from 0; index into a list of the rules. */
  readonly size?: number;
  readonly entry?: number;
  /** Number of the cycle or tool concerned, or the word. */
  readonly about?: number | string;
  /** Why material is left, if the operation that should have cut it knows the reason. */
  readonly reason?: Reason;
  /** The finding of the run or of the stock that this mark reports. */
  readonly issue?: RunFinding["issue"];
  /** How far a cut goes into the part, mm. */
  readonly depth?: number;
  /** The parameter that shapes the contour at the place, or the block of a programmed contour. */
  readonly shapedBy?: { readonly q: string } | { readonly block: number };
  /** The tool is to blame: no slip in the dimensions explains why it is refused. */
  readonly isByTool?: boolean;
  /** The slip that explains the fault. */
  readonly slip?: Slip;
}

/** Points of a free program, out of 100; 0 while it damages the part, runs into material or is not proved. */
export interface Score {
  readonly total: number;
  readonly parts: readonly ScorePart[];
}
export interface ScorePart {
  /** "proof": share of the rules that hold; "residue", "time" and "tools": compared with a good answer. */
  readonly what: "proof" | "residue" | "time" | "tools";
  readonly points: number;
  readonly of: number;
  /** mm², s, or tools; a count of rules for the proof. */
  readonly value: number;
  readonly par: number;
}

export interface TaskJudgement {
  readonly passed: boolean;
  /** In the order of `RULES`; within a rule the gravest first. */
  readonly marks: readonly TaskMark[];
  /** Only for a "drawing". */
  readonly score?: Score;
}
