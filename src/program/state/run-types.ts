import type { Given } from "../../cycles/define.ts";
import type { Params, Values } from "../../cycles/params.ts";
import type { Cuboid } from "../../kernel/area/box.ts";
import type { Clamped } from "../../kernel/area/clamping.ts";
import type { Issue } from "../../kernel/plan/issue.ts";
import type { FeedUnit } from "../../kernel/plan/move.ts";
import type { Plan } from "../../kernel/plan/plan.ts";
import type { Pt, Ring } from "../../kernel/geometry/point.ts";
import type { Spindle, Stated, Step, Unproved } from "../../kernel/time/step.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { Feed } from "../../kernel/units.ts";
import type { NcIssue } from "../../nc/issue.ts";
import type { SpindleData } from "../machine/machine-data.ts";
import type { Datum } from "./modal.ts";
import type { ProgramIssue } from "./issue.ts";
import type { ApproachRun, PlaneStep } from "../tools/plane-types.ts";

/** A finding of any layer with its place in the program. */
export interface RunFinding {
  readonly issue: Issue | NcIssue | ProgramIssue;
  /** Number of the block, as printed or counted on; null when it concerns the whole program. */
  readonly block: number | null;
  /** Line in the text, from 1; null when it concerns the whole program. */
  readonly line: number | null;
  /** Index into `Run.operations` when it belongs to a cycle call. */
  readonly operation: number | null;
  /** Where it stands in the file of a called program; `block` and `line` are those of the call then. */
  readonly inFile?: { readonly file: string; readonly block: number | null; readonly line: number };
}

/** A line of the program, or of a file that it calls. */
export interface TextLine {
  /** From 1. */
  readonly line: number;
  /** Absent for the program itself. */
  readonly file?: string;
}

/** One executed cycle call. */
export interface Operation {
  /** Number of the block that calls the cycle. */
  readonly block: number;
  /** Number of the block that defines it, and that definition's line (from 1). */
  readonly definedIn: number;
  readonly definedLine: number;
  /** File of the called program that defines it, which block and line are of then; absent for the program itself. */
  readonly definedFile?: string;
  readonly cycle: number;
  readonly tool: Tool;
  /** Theoretical tip at the call. */
  readonly start: Pt;
  readonly feedUnit: FeedUnit;
  readonly spindle: Spindle | null;
  readonly plan: Plan;
  /** Time of its moves. */
  readonly seconds: number;
  /** Its steps in `Run.steps`, both included; `lastStep` is `firstStep - 1` when there are none. */
  readonly firstStep: number;
  readonly lastStep: number;
  /** Issues of the values, the tool and the plan. */
  readonly issues: readonly Issue[];
  /**
   * Where each segment of the contour that it was given is written, in programmed order; absent where it follows none.
   */
  readonly contourLines?: readonly TextLine[];
  /**
   * What the cycle was called with, so that it can be planned again with another tool; null when its values make none.
   */
  readonly call: {
    readonly values: Values<Params>;
    readonly given: Given;
    readonly autoFeed: Feed | null;
    /** The tip at the call as the program counts it, and how far its datum stands from that of the workpiece. */
    readonly start: Pt;
    readonly datum: Pick<Datum, "x" | "z">;
  } | null;
}

/**
 * Seconds that pass beside the motions: tool changes, the spindle getting to its speed, dwells that are blocks of their
 * own.
 */
export interface SecondsBeside {
  readonly toolChange: number;
  readonly spindle: number;
  readonly dwell: number;
}

/** What a time can contain, in the order in which it is told. */
export const TIME_PARTS = ["cutting", "rapid", "dwell", "acceleration", "toolChange", "spindle"] as const;
export type TimePart = (typeof TIME_PARTS)[number];

/** What the running time was worked out with. */
export interface Timing {
  readonly beside: SecondsBeside;
  readonly contains: readonly TimePart[];
  /** Name of the machine whose data were used; null without one. */
  readonly machine: string | null;
  /** What its spindle can give. */
  readonly turning: SpindleData | null;
  /** Rapid rates, mm/min: of each axis, or one along the path. */
  readonly rates: number | { readonly x: number; readonly z: number };
}

/** What a program does: everything that simulation, pictures and reports are made from. Plain data. */
export interface Run {
  readonly program: { readonly name: string; readonly unit: "mm" | "inch"; readonly blocks: number };
  /** Outlines of the blank in the half plane, outer rings counter-clockwise; empty when the program states none. */
  readonly blank: readonly Ring[];
  /** What the work is held by; null where the program states nothing. */
  readonly clamping: Clamped | null;
  /** The box that BLK FORM 0.1 and 0.2 state, for what is milled; null for other forms. */
  readonly cuboid: Cuboid | null;
  /** Blanks that the program states after it has begun to cut, in the order of the steps. */
  readonly stated: readonly Stated[];
  readonly operations: readonly Operation[];
  readonly steps: readonly Step[];
  /** For each step the index of its block in the parsed program, which stays unique when block numbers do not. */
  readonly stepBlocks: readonly number[];
  /** What is milled in the X/Y plane: the path of the tool centre. */
  readonly plane: readonly PlaneStep[];
  /** Every APPR and DEP with its points, in both planes, in the order they ran. */
  readonly approaches: readonly ApproachRun[];
  /**
   * Where a turning program counts from, from a step on, in the order of the steps; empty when that is the workpiece
   * zero throughout.
   */
  readonly datums: readonly { readonly step: number; readonly at: Pt }[];
  /**
   * How the spindle turns, from a step on, in the order of the steps; null until a speed was programmed. M4 turns it
   * backwards.
   */
  readonly spindles: readonly { readonly step: number; readonly spindle: Spindle | null; readonly backwards?: true }[];
  /** What was not simulated though it can move the path or the stock, in the order it was met. */
  readonly unproved: readonly Unproved[];
  /** All findings in the order of the text, those of operations included. */
  readonly issues: readonly RunFinding[];
  /** Whole running time, as far as `timing` says. */
  readonly seconds: number;
  readonly timing: Timing;
}
