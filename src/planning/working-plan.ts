import type { Site } from "../cycles/shape-request.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import type { Judged } from "../report/verdict.ts";
import type { OpenRegion } from "./open-regions.ts";
import type { HandValues, PlanRequest, TriedAction } from "./types.ts";

/** Rules of the trade by their name: each makes a plan that breaks it dearer, none forbids. */
export type TradeRule =
  | "roughBeforeFinish"
  | "outsideBeforeInside"
  | "longBeforeThin"
  | "tolerancedLast"
  | "undercutBeforeThread"
  | "faceFirst";

/** Why a step is what it is and stands where it stands. Another way is named by its cycle (null: path blocks) and tool. */
export type StepReason =
  /** No other tool takes this material. */
  | { readonly kind: "onlyTool"; readonly tool: number }
  /** Other tools do it, no other cycle does. */
  | { readonly kind: "onlyCycle"; readonly cycle: number | null }
  /** Quicker than the next way, tool changes included, s. */
  | { readonly kind: "faster"; readonly seconds: number; readonly cycle: number | null; readonly tool: number }
  /** The next way takes as long and leaves as much: the usual one is taken. */
  | { readonly kind: "equal"; readonly cycle: number | null; readonly tool: number }
  /** Takes more material than the quickest other way, mm² of the half plane. */
  | { readonly kind: "takesMore"; readonly area: number; readonly cycle: number | null; readonly tool: number }
  /** The next way needs a tool that the operator's table lacks. */
  | { readonly kind: "ownTool"; readonly cycle: number | null; readonly tool: number }
  /** Roughs and finishes in one call. */
  | { readonly kind: "inOneCall" }
  /** Drilled under size for a reamer. */
  | { readonly kind: "undersize"; readonly tool: number }
  /** The tool is in the spindle already. */
  | { readonly kind: "sameTool"; readonly tool: number }
  /** A rule of the trade put it before or behind others. */
  | { readonly kind: "rule"; readonly rule: TradeRule }
  /** Takes what an earlier step (its index) left. */
  | { readonly kind: "rest"; readonly step: number }
  /** Parts off a part on which material (mm² of the half plane) or threads are left that no tool can make. */
  | { readonly kind: "unfinished"; readonly area: number; readonly threads: readonly string[] }
  /** Chosen, changed or locked by the operator. */
  | { readonly kind: "byHand" };

/** Another way to make a step, tried on the same stock. */
export interface OtherWay {
  readonly tried: TriedAction;
  /** Time with its tool change, and how much more that is than the step's, s. */
  readonly seconds: number;
  readonly longer: number;
  /** Material that it leaves and the step takes, mm² of the half plane; negative: it takes more. */
  readonly leaves: number;
}

/** A step of a working plan. */
export interface PlanStep {
  readonly tried: TriedAction;
  /** Time of the step with its tool change, s; what rules of the trade add to its cost, s. */
  readonly seconds: number;
  readonly penalty: number;
  readonly why: readonly StepReason[];
  /** At most two, the best first. Their `tried.action.key` goes into `PlanChanges.instead`. */
  readonly others: readonly OtherWay[];
  /** Chosen, changed or locked by the operator. */
  readonly isByHand: boolean;
}

/** The smallest data of a tool that would take some material. Lengths mm, angles degrees; absent: anything will do. */
export interface MissingTool {
  readonly form: "turning" | "recessing" | "boring" | "drill" | "thread";
  readonly site: Site;
  /** Which way it cuts: towards the chuck or away from it. */
  readonly hand?: "right" | "left";
  /** Angle of the steepest flank that the main edge cuts up to, measured from the axis: the least setting angle. */
  readonly rises?: number;
  /** Least angle that the insert keeps clear of the flank it descends along, measured from the axis. */
  readonly descends?: number;
  /** Least angle of its main edge from the axis (T-ANGLE), where a face leans over its own foot. */
  readonly leastEdge?: number;
  readonly mostNose?: number;
  readonly mostWidth?: number;
  readonly leastDepth?: number;
  /** A groove in a face: diameters between which the first plunge lies. */
  readonly across?: readonly [least: number, most: number];
  /** Greatest diameter of a bar or a drill, least reach into the bore. */
  readonly mostDiameter?: number;
  readonly leastReach?: number;
  /** Designation of a thread without a tool. */
  readonly thread?: string;
}

/** What the plan does not make: material, or a thread by its designation. */
export type Residue = ResidueFacts &
  ({ readonly region: OpenRegion; readonly thread: null } | { readonly region: null; readonly thread: string });
interface ResidueFacts {
  readonly site: Site;
  /** Rows of the elements that it lies on; see ElementMark. */
  readonly rows: readonly string[];
  /**
   * No tool of the table does it; a tool or cycle that does it is excluded; the jaws cover it; only the rear reaches it;
   * the ways that were tried stopped with a fault; the search ended before.
   */
  readonly why: "tool" | "excluded" | "clamping" | "rear" | "fault" | "bound";
  readonly missing: MissingTool | null;
}

/** A whole plan for one clamping. */
export interface WorkingPlan {
  /** Part, blank and clamping as this clamping has them: the second one has its part turned end for end. */
  readonly setup: Pick<PlanRequest, "part" | "blank" | "clamping">;
  readonly steps: readonly PlanStep[];
  /** The program in the language of `PlanRequest.labels`. */
  readonly text: string;
  /** Time of the whole program, tool changes included, s. */
  readonly seconds: number;
  /** Time of the program as its run states it, s: tool changes count only where the machine data states their time. */
  readonly programSeconds: number;
  /** Time of the tool changes by the rules of the shop, s: what `seconds` has more; zero where the machine states it. */
  readonly changeSeconds: number;
  /** Numbers of its tools, in the order of their first use. */
  readonly tools: readonly number[];
  readonly toolChanges: number;
  readonly stock: readonly Ring[];
  /** The check of the whole program. */
  readonly judged: Judged;
  /** Material of the finished part that it takes, mm² of the half plane. */
  readonly gouge: number;
  readonly residue: readonly Residue[];
  /** Proved, nothing taken from the part, nothing left that this clamping has to make. */
  readonly isComplete: boolean;
  /** The plan of the other end, where material is left that only the rear reaches. */
  readonly second: WorkingPlan | null;
  /** Simulated actions. */
  readonly tries: number;
}

/** The search so far. */
export interface PlanProgress {
  /** Simulated actions, and the bound at which the search ends. */
  readonly tries: number;
  readonly most: number;
  /** False until the first whole plan: from then on it is the best one so far. */
  readonly isWhole: boolean;
  /** The best plan so far: its actions, stock, time, and the material outside the part, mm² of the half plane. */
  readonly done: readonly TriedAction[];
  readonly stock: readonly Ring[];
  readonly seconds: number;
  readonly left: number;
}

/** What an operator has decided about the operations of one clamping, each named by its `action.key`. */
export interface ClampingChanges {
  /** The former plan: its operations are kept from the first one on as long as they are possible and work. */
  readonly keep?: readonly string[];
  /** Another way in place of the step at this index; the steps before it are kept. */
  readonly instead?: { readonly at: number; readonly actionKey: string };
  /** Operations that are locked, with the values set by hand: each takes the place of other ways to do the same. */
  readonly hand?: Readonly<Record<string, HandValues>>;
}

/** What an operator has decided about a plan that exists. */
export interface PlanChanges extends ClampingChanges {
  readonly second?: ClampingChanges;
}
