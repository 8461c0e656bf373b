import type { Site } from "../cycles/shape-request.ts";
import type { Clamped } from "../kernel/area/clamping.ts";
import type { Ring, Segment } from "../kernel/geometry/point.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import type { Program } from "../nc/program.ts";
import type { Statement } from "../nc/statement.ts";
import type { SetJob } from "../program/job/job.ts";
import type { Labels } from "../program/job/print-job.ts";
import type { Shop } from "../program/state/shop.ts";
import type { VerdictReason } from "../report/verdict.ts";
import type { ValueFormula } from "./values/formulas.ts";

/** What the drawing says about an element besides its geometry. */
export interface ElementMark {
  /** Row of the contour table that made the element, to select it in a picture. */
  readonly row: string;
  /** Greatest arithmetical mean roughness, µm. */
  readonly roughness?: number;
  /** Greatest mean roughness depth, µm. */
  readonly rz?: number;
  /** Designation of a thread on this cylinder or cone, as typed: "M30x1.5". */
  readonly thread?: string;
  /** Designation of the undercut that the element belongs to: "DIN 76-A 1.5". */
  readonly undercut?: string;
  /** Tolerance as typed: "h6", "+0.02/-0.01". The geometry has its middle. */
  readonly tolerance?: string;
}

/** A side of the finished part: its elements from the front face to the rear, each with its mark. */
export interface Chain {
  readonly segments: readonly Segment[];
  /** One for each segment. */
  readonly marks: readonly ElementMark[];
}

/** A finished part as geometry, mm, sizes at the middle of their tolerances. Z0 is the finished front face. */
export interface PlannedPart {
  readonly name: string;
  /** Begins on the axis, or at the edge of the bore, with the front face; ends at the outer edge of the rear face. */
  readonly outside: Chain;
  /** Begins at the front face; ends on the axis at the bottom of a blind bore, or at the rear face. Empty when solid. */
  readonly inside: Chain;
  /** The closed half section. */
  readonly rings: readonly Ring[];
}

/** Costs beside the time of the machine that a shop can set, seconds each. */
export interface ShopRules {
  /** Time of a tool change where the machine states none, s. */
  readonly toolChange: number;
  /** Price of a tool that the table lacks, once for each, s. */
  readonly usualTool: number;
  /**
   * Penalties: a finished surface before roughing has ended, inside before outside, a thin section early, other work
   * after a toleranced surface was finished, s.
   */
  readonly finishBeforeRough: number;
  readonly insideBeforeOutside: number;
  readonly thinBeforeLong: number;
  readonly tolerancedLast: number;
  /** Oversize for finishing, mm: on the diameter and along Z. */
  readonly allowance: { readonly diameter: number; readonly z: number };
}

/** Everything a plan is made from. */
export interface PlanRequest {
  readonly part: PlannedPart;
  /** The stock in the chuck, mm. */
  readonly blank: readonly Ring[];
  readonly clamping: Clamped | null;
  /** Tools, drills, machine. */
  readonly shop: Shop;
  /** Material by its id in the cutting data. */
  readonly material: string;
  readonly rules: ShopRules;
  /** Series from bar: the part is parted off. */
  readonly partsOff: boolean;
  /** Cycles and tools that the operator has excluded, by number. */
  readonly withoutCycles: readonly number[];
  readonly withoutTools: readonly number[];
  /** Tools of the shop that the operator's own table lacks, by number; absent: none. */
  readonly usualTools?: readonly number[];
  readonly labels: Labels;
  /** The program that the operations are added to; absent: an empty one with a cylinder around the blank. */
  readonly begun?: Program;
  /** Words of the structure item of each kind of operation, in the language of the labels; absent: none. */
  readonly titles?: Readonly<Record<ActionKind, string>>;
}

/** Kinds of actions, in the usual order of a working plan. */
export const ACTION_KINDS = [
  "face",
  "centre",
  "drill",
  "roughOutside",
  "roughInside",
  "restRough",
  "recess",
  "finishOutside",
  "finishInside",
  "ream",
  "undercut",
  "thread",
  "partOff",
] as const;
export type ActionKind = (typeof ACTION_KINDS)[number];

/** Kinds that finish a surface. */
export const FINISHING: ReadonlySet<ActionKind> = new Set(["finishOutside", "finishInside", "ream", "thread"]);

/** Kinds that take material for other kinds to finish. */
export const ROUGHING: ReadonlySet<ActionKind> = new Set([
  "drill",
  "roughOutside",
  "roughInside",
  "restRough",
  "recess",
]);

/** A value of an action with the reason for it; the formula and its inputs are those of `values/`. */
export interface ReasonedValue {
  /** The parameter ("Q463") or the place of the set-up ("speed"). */
  readonly q: string;
  readonly value: number;
  readonly formula: ValueFormula;
  /** By the symbols of the formula. */
  readonly inputs: Readonly<Record<string, number | string>>;
}

/** Values of an operation that an operator sets, by parameter ("Q463") or place of the set-up ("speed", "start.x"). */
export type HandValues = Readonly<Record<string, number>>;

/** One operation that could be next: nothing has been tried yet. */
export interface Action {
  readonly kind: ActionKind;
  /** The same for the same kind, cycle, tool and place: decides equal costs. */
  readonly key: string;
  readonly site: Site;
  readonly tool: Tool;
  /** The cycle; null for path blocks. */
  readonly cycle: number | null;
  /** The job of the operation. With `cut` its blocks replace those of the cycle. */
  readonly job: SetJob;
  readonly cut?: readonly Statement[];
  /** The box that it works in, mm: Z from front to rear, radii from outside to inside. */
  readonly place: { readonly front: number; readonly rear: number; readonly high: number; readonly low: number };
  /** Threads that it makes, by their designation and place: they are no area. */
  readonly threads: readonly string[];
  /** It roughs and finishes in one call. */
  readonly inOneCall?: true;
  /** The reamer for which it drills under size. */
  readonly reamer?: number;
  readonly values: readonly ReasonedValue[];
  /** What was planned for the values that an operator has set; absent where none is. */
  readonly planned?: HandValues;
}

/** What an action did to a stock. */
export interface TriedAction {
  readonly action: Action;
  readonly stock: readonly Ring[];
  /** Time without the tool change, s. */
  readonly seconds: number;
  /** Stock that it took, and material of the finished part that it took, mm² of the half plane. */
  readonly cut: number;
  readonly gouge: number;
  readonly faults: readonly VerdictReason[];
  /** It cut something and did no damage. */
  readonly works: boolean;
}

/** A point of the search: the stock after some actions. */
export interface PlanState {
  readonly stock: readonly Ring[];
  readonly done: readonly TriedAction[];
  /** Threads that are made. */
  readonly threads: ReadonlySet<string>;
}

/** A kind of action: which operations could be next in a state. Cheap, no simulation; deterministic order. */
export interface ActionSource {
  readonly kind: ActionKind;
  /** Its actions rough and finish in one call. */
  readonly inOneCall?: true;
  actions(state: PlanState, request: PlanRequest): readonly Action[];
}
