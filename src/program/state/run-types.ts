import type { Given } from "../../cycles/define.ts";
import type { Params, Values } from "../../cycles/params.ts";
import type { Cuboid } from "../../kernel/area/box.ts";
import type { Clamped } from "../../kernel/area/clamping.ts";
import type { Issue } from "../../kernel/plan/issue.ts";
import type { FeedUnit } from "../../kernel/plan/move.ts";
import type { Plan } from "../../kernel/plan/plan.ts";
import type { Pt, Ring } from "../../kernel/geometry/point.ts";
import type { Spindle, StatedBlank, Step, UnsimulatedBlock } from "../../kernel/time/step.ts";
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
  /** Number of the block, printed or counted; null when the finding concerns the whole program. */
  readonly block: number | null;
  /** Line in the text, from 1; null when it concerns the whole program. */
  readonly line: number | null;
  /** Index into `Run.operations` when it belongs to a cycle call. */
  readonly operation: number | null;
  /** Place in a called file; `block` and `line` are then those of the call. */
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
  /** Called file with the definition, whose block and line are given; absent for the main program. */
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
  /** Line of each segment of its contour, in programmed order; absent without a contour. */
  readonly contourLines?: readonly TextLine[];
  /** Inputs of the call, to plan it again with another tool; null when its values are invalid. */
  readonly call: {
    readonly values: Values<Params>;
    readonly given: Given;
    readonly autoFeed: Feed | null;
    /** Tip at the call in program coordinates, and the offset of the datum from that of the workpiece. */
    readonly start: Pt;
    readonly datum: Pick<Datum, "x" | "z">;
  } | null;
}

/** Seconds outside of motions: tool changes, spindle run-up, dwell blocks. */
export interface NonMotionSeconds {
  readonly toolChange: number;
  readonly spindle: number;
  readonly dwell: number;
}

/** Parts of a running time, in display order. */
export const TIME_PARTS = ["cutting", "rapid", "dwell", "acceleration", "toolChange", "spindle"] as const;
export type TimePart = (typeof TIME_PARTS)[number];

/** Basis of the running time. */
export interface Timing {
  readonly beside: NonMotionSeconds;
  readonly contains: readonly TimePart[];
  /** Name of the machine whose data were used; null without one. */
  readonly machine: string | null;
  /** Data of its spindle. */
  readonly turning: SpindleData | null;
  /** Rapid rates, mm/min: of each axis, or one along the path. */
  readonly rates: number | { readonly x: number; readonly z: number };
}

/** Result of running a program: the basis of simulation, pictures and reports. Plain data. */
export interface Run {
  readonly program: { readonly name: string; readonly unit: "mm" | "inch"; readonly blocks: number };
  /** Outlines of the blank in the half plane, outer rings counter-clockwise; empty when the program states none. */
  readonly blank: readonly Ring[];
  /** Clamping; null where the program states none. */
  readonly clamping: Clamped | null;
  /** The box that BLK FORM 0.1 and 0.2 state, for what is milled; null for other forms. */
  readonly cuboid: Cuboid | null;
  /** Blanks stated after the first cut, in step order. */
  readonly stated: readonly StatedBlank[];
  readonly operations: readonly Operation[];
  readonly steps: readonly Step[];
  /** For each step the index of its block in the parsed program, which stays unique when block numbers do not. */
  readonly stepBlocks: readonly number[];
  /** Milling in the X/Y plane: the path of the tool centre. */
  readonly plane: readonly PlaneStep[];
  /** Every APPR and DEP with its points, in both planes, in the order they ran. */
  readonly approaches: readonly ApproachRun[];
  /** Datum of a turning program from a step on, in step order; empty when it is always the workpiece zero. */
  readonly datums: readonly { readonly step: number; readonly at: Pt }[];
  /** Spindle state from a step on, in step order; null until a speed is programmed. M4 reverses it. */
  readonly spindles: readonly { readonly step: number; readonly spindle: Spindle | null; readonly backwards?: true }[];
  /** Blocks not simulated that can change path or stock, in run order. */
  readonly unproved: readonly UnsimulatedBlock[];
  /** All findings in the order of the text, those of operations included. */
  readonly issues: readonly RunFinding[];
  /** Total running time in s, as far as `timing` covers it. */
  readonly seconds: number;
  readonly timing: Timing;
}
