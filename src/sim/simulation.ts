import type { PackedRings } from "../kernel/area/clip.ts";
import type { Clamped, ClampPart } from "../kernel/area/clamping.ts";
import type { Issue, Reason } from "../kernel/plan/issue.ts";
import type { MachiningLimit, Plan } from "../kernel/plan/plan.ts";
import type { Pt, Ring } from "../kernel/geometry/point.ts";
import type { Idle, NeededHole, Stated, Step, Unproved } from "../kernel/time/step.ts";
import type { Tool } from "../kernel/plan/tool.ts";

/** One executed cycle call: its plan and its steps, `firstStep` to `lastStep` included (none: lastStep < firstStep). */
export interface SimulatedOperation {
  readonly plan: Plan;
  readonly tool: Tool;
  readonly firstStep: number;
  readonly lastStep: number;
  /** Issues of values, tool and plan: one that failed is not blamed for what it did not cut. */
  readonly issues?: readonly Issue[];
}

/** What is simulated. The blank is what stands in the chuck at the first step. */
export interface SimulationInput {
  readonly blank: readonly Ring[];
  /** Blanks that are stated later, in the order of their steps; none where absent. */
  readonly stated?: readonly Stated[];
  /** What the work is held by, where that is stated. */
  readonly clamping?: Clamped | null;
  readonly steps: readonly Step[];
  readonly operations: readonly SimulatedOperation[];
  /** What the run read and did not simulate. */
  readonly unproved: readonly Unproved[];
}

/** A moment of the run: a fraction 0 … 1 of the way of a step. The end is `{ step: steps.length, fraction: 0 }`. */
export interface PlayPosition {
  readonly step: number;
  readonly fraction: number;
}

/**
 * A mark before step `step`, where cutting begins anew with the stock as it is. Steps between are cut again from the
 * nearest mark before that has its stock; long runs keep those of some marks only.
 */
export interface Checkpoint {
  readonly step: number;
  readonly stock: PackedRings | null;
  /** True where the program states another blank: its stock is kept, and is not what was left before. */
  readonly isStated?: true;
  /** True where pieces came loose: its stock is kept, and is what is still held. */
  readonly isParted?: true;
}

/** What must not happen in a stock. */
export const STOCK_FAULTS = [
  "gouge",
  "rapidInStock",
  "holderContact",
  "clampContact",
  "cutOnLoosePiece",
  "rapidBehindBlank",
  "spindleStopped",
  "holeMissing",
] as const;
export type StockFault = (typeof STOCK_FAULTS)[number];

/** What may be meant: plain cuts below the contour of a cycle, and feeds behind the blank. */
export type StockRemark = "cutBelowContour" | "feedBehindBlank";

/** Something found by the stock: where the tool cut the finished part, ran into material, or stood behind the blank. */
export interface StockFinding<Kind = StockFault> {
  readonly kind: Kind;
  /** What of the clamping was met, and by what; of a clampContact only. */
  readonly clamp?: { readonly part: ClampPart; readonly by: "tool" | "holder" };
  readonly step: number;
  readonly block: number;
  readonly operation: number | null;
  /** A point inside the place, for the mark in the picture. */
  readonly place: Pt;
  /** mm² in the half plane. */
  readonly area: number;
  readonly rings: readonly Ring[];
  /** Why the spindle does not turn as it must, where that is the fault. */
  readonly idle?: Idle;
  /** The hole that is missing, mm, and the number of the tool that needs it. */
  readonly hole?: NeededHole & { readonly tool: number };
  /** Moves that did it in this place; `step` is the first of them. */
  readonly moves: number;
  /**
   * The block that it is about beside its own: the cycle whose contour a plain cut goes below, or what cut a piece
   * loose.
   */
  readonly other?: number;
  /** The operation whose contour a plain cut goes below. */
  readonly below?: number;
  /** Where the blank ends that it is behind of, Z in mm. */
  readonly rear?: number;
  /** A plain cut below a contour that is no fault; it is kept while the run may still change. */
  readonly isMeant?: true;
}

export type AnyFinding = StockFinding<StockFault | StockRemark>;

/** Material inside the area of the operations that is still there at the end. */
export interface Residual {
  readonly area: number;
  /** Diameter of the largest circle in it, mm. */
  readonly thickness: number;
  readonly reason: Reason;
  readonly ring: Ring;
  /** A point inside. */
  readonly place: Pt;
  /** The operation that should have taken it. */
  readonly operation: number;
  /** True where the values of that operation ask for it. */
  readonly isAsked?: true;
}

/** What became of a blank that was stated while the program ran, mm². */
export interface StatedProof {
  readonly step: number;
  readonly block: number;
  readonly what: string;
  /** What stood beyond the outline: nobody knows where it went. */
  readonly lacks: number;
  /** What the outline has where nothing stood any more. */
  readonly adds: number;
}

/** A piece lies in front of what is held, round it as a ring, or inside it as a slug. */
export type LooseShape = "piece" | "ring" | "slug";

/** A piece that no longer hangs together with the clamped end. It has left the stock. */
export interface LoosePiece {
  /** Index of the step that comes after it fell off. */
  readonly step: number;
  /** The block that cut it loose. */
  readonly block: number;
  readonly operation: number | null;
  readonly shape: LooseShape;
  /** A blade or a cut outside cycles has parted it off on purpose. */
  readonly isPartedOff: boolean;
  readonly rings: readonly Ring[];
  readonly area: number;
  /** A point inside. */
  readonly place: Pt;
}

/** Sums over the run in mm² of the half plane. */
export interface Proof {
  readonly gouge: number;
  readonly rapidInStock: number;
  readonly residual: readonly Residual[];
  /** Stock that feed moves removed; also what rapids did, from `unlooked` on. */
  readonly cut: number;
  /** Roughing passes and passes of a thread that touched no stock. */
  readonly airPasses: number;
  /** The roughing pass that goes deepest into the stock against what its cycle allows, mm; null without roughing. */
  readonly deepest: Depth | null;
  /** Whether a holder touched the stock or the clamping; unknown when a tool that moved has none. */
  readonly holder: "clear" | "contact" | "unknown";
  /**
   * From this step on nobody looked for gouges, rapids in stock and contacts of the holder, because there are too many;
   * null: all were looked for.
   */
  readonly unlooked: { readonly step: number; readonly block: number } | null;
  readonly unproved: readonly Unproved[];
  readonly stated: readonly StatedProof[];
  /** What came off the held end, in the order of the run; it has left the stock. */
  readonly loose: readonly LoosePiece[];
  /** Where the outside is turned to the very end at which the blank is held; null: something is left to hold. */
  readonly unheld: Unheld | null;
  readonly remarks: readonly StockFinding<StockRemark>[];
  /** For each operation of the run, in its order. */
  readonly operations: readonly OperationProof[];
}

/** The operation or the block that left nothing to hold at the rear end, and a place there. */
export interface Unheld {
  readonly step: number;
  readonly block: number;
  readonly operation: number | null;
  readonly place: Pt;
  /** Where the blank ends, Z in mm. */
  readonly rear: number;
}

/** A measured depth against what is allowed, mm; `allowed` is 0 when nothing limits it. */
export interface Depth {
  readonly depth: number;
  readonly allowed: number;
  readonly step: number;
  readonly block: number;
  /** The roughing pass, from 1; absent on a smoothing or finishing cut. */
  readonly pass?: number;
}

/** Material that an operation took on the side of a limit that is not to be cut. */
export interface BehindLimit {
  readonly limit: MachiningLimit;
  /** mm² of the half plane. */
  readonly area: number;
  /** The largest piece of it, a point inside, and the first of the moves that took it. */
  readonly ring: Ring;
  readonly place: Pt;
  readonly step: number;
  readonly block: number;
  /** True when roughing ran as well, and took nothing there. */
  readonly finishing: boolean;
}

/** How much material lacks at the crest of a thread, mm, and where that crest would be. */
export interface MissingCrest {
  readonly missing: number;
  /** The thread lies in a face: it lacks along Z. */
  readonly inFace: boolean;
  readonly z: number;
  readonly r: number;
}

/** Where a thread runs, for what it does wrong behind its end. */
export interface ThreadWay {
  readonly crest: readonly Pt[];
  /** Where the tip comes to a stop. */
  readonly stop: Pt;
  /** Unit direction out of the material. */
  readonly openSide: Pt;
}

/** What one operation did to the stock. */
export interface OperationProof {
  /** Stock that its feed moves removed, mm² of the half plane. */
  readonly cut: number;
  /** Roughing passes and passes of a thread that touched no stock. */
  readonly airPasses: number;
  /** Of a thread, before its first pass; null where its crest is there. */
  readonly crest: MissingCrest | null;
  /** Null of other operations. */
  readonly thread: ThreadWay | null;
  /**
   * The roughing pass that goes deepest, along the direction of infeed, against the greatest infeed; null without
   * roughing.
   */
  readonly deepest: Depth | null;
  /**
   * The smoothing or finishing cut that takes more than the oversize and one infeed, square to its path; null when none
   * does.
   */
  readonly thickest: Depth | null;
  /** What was taken behind each machining limit that was crossed in material. */
  readonly behindLimits: readonly BehindLimit[];
  /** Where the insert stands in the stock when the operation begins; null where it is free. */
  readonly startInMaterial: Pt | null;
  /** True when an error kept it from its path, or there was no stock: that it cut nothing is no news then. */
  readonly hasFailed: boolean;
  /** The sign or the order of a dimension is questioned: what tool and stock say to it follows from that. */
  readonly isQuestioned: boolean;
}

/**
 * Over a whole program: "faults": errors or findings; "incomplete": something was not simulated, an operation cut
 * nothing, or there was no operation at all.
 */
export type Verdict = "proved" | "faults" | "incomplete";

/** A simulated run: plain data, so it can be sent between threads. */
export interface Simulation {
  readonly blank: readonly Ring[];
  readonly steps: readonly Step[];
  readonly checkpoints: readonly Checkpoint[];
  readonly final: readonly Ring[];
  /** Seconds from the beginning to the start of each step, and to the end: one more than there are steps. */
  readonly startTimes: Float64Array;
  readonly totalSeconds: number;
  readonly findings: readonly StockFinding[];
  readonly proof: Proof;
}
