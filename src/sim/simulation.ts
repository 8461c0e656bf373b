import type { PackedRings } from "../kernel/area/clip.ts";
import type { Clamped, ClampPart } from "../kernel/area/clamping.ts";
import type { Issue, Reason, ToolLimit } from "../kernel/plan/issue.ts";
import type { MachiningLimit, Plan } from "../kernel/plan/plan.ts";
import type { Pt, Ring } from "../kernel/geometry/point.ts";
import type { SpindleFault, NeededHole, StatedBlank, Step, UnsimulatedBlock } from "../kernel/time/step.ts";
import type { Tool } from "../kernel/plan/tool.ts";

/** One executed cycle call: its plan and its steps, `firstStep` to `lastStep` included (none: lastStep < firstStep). */
export interface SimulatedOperation {
  readonly plan: Plan;
  readonly tool: Tool;
  readonly firstStep: number;
  readonly lastStep: number;
  /** Issues of values, tool and plan: a failed operation is not blamed for uncut material. */
  readonly issues?: readonly Issue[];
}

/** Inputs of a simulation. The blank is the one in the chuck at the first step. */
export interface SimulationInput {
  readonly blank: readonly Ring[];
  /** What is held, where the blank is what operations before this run left of it; absent: the blank. */
  readonly held?: readonly Ring[];
  /** Blanks that are stated later, in the order of their steps; none where absent. */
  readonly stated?: readonly StatedBlank[];
  /** The clamping, where stated. */
  readonly clamping?: Clamped | null;
  readonly steps: readonly Step[];
  readonly operations: readonly SimulatedOperation[];
  /** What the run read and did not simulate. */
  readonly unproved: readonly UnsimulatedBlock[];
}

/** A moment of the run: a fraction 0 … 1 of the way of a step. The end is `{ step: steps.length, fraction: 0 }`. */
export interface PlayPosition {
  readonly step: number;
  readonly fraction: number;
}

/**
 * A mark before step `step`, at which the stock is recomputed. Steps between marks are cut again from the nearest
 * earlier mark with a stored stock; long runs store only some.
 */
export interface Checkpoint {
  readonly step: number;
  readonly stock: PackedRings | null;
  /** True where the program states another blank: the stock is stored, and is not the result of the cuts before. */
  readonly isStated?: true;
  /** True where pieces came loose: the stock is stored, and is the part still held. */
  readonly isParted?: true;
}

/** Faults found in the stock. */
export const STOCK_FAULTS = [
  "gouge",
  "rapidInStock",
  "holderContact",
  "clampContact",
  "cutOnLoosePiece",
  "rapidBehindBlank",
  "spindleStopped",
  "holeMissing",
  "toolLimit",
] as const;
export type StockFault = (typeof STOCK_FAULTS)[number];

/**
 * Findings that are no fault by themselves: plain cuts below the contour of a cycle, in question or marked as intended,
 * and feeds behind the blank.
 */
export type StockRemark = "cutBelowContour" | "intendedCut" | "feedBehindBlank";

/** A finding in the stock: the tool damaged the finished part, ran into material, or was behind the blank. */
export interface StockFinding<Kind = StockFault> {
  readonly kind: Kind;
  /** The clamping part that was hit, and by what; only for clampContact. */
  readonly clamp?: { readonly part: ClampPart; readonly by: "tool" | "holder" };
  readonly step: number;
  readonly block: number;
  readonly operation: number | null;
  /** A point inside the finding's area, for the mark in the picture. */
  readonly place: Pt;
  /** mm² in the half plane. */
  readonly area: number;
  readonly rings: readonly Ring[];
  /** Why the spindle does not turn as required, where that is the fault. */
  readonly idle?: SpindleFault;
  /** The hole that is missing, mm, and the number of the tool that needs it. */
  readonly hole?: NeededHole & { readonly tool: number };
  /** The limit that the row of the tool states, and what the step makes of it, mm; only for toolLimit. */
  readonly limit?: {
    readonly tool: number;
    readonly column: ToolLimit;
    readonly value: number;
    readonly limit: number;
  };
  /** Number of moves with this finding in this place; `step` is the first. */
  readonly moves: number;
  /**
   * A second block of the finding: the cycle whose contour a plain cut goes below, or the block that cut a piece loose.
   */
  readonly other?: number;
  /** The operation whose contour a plain cut goes below. */
  readonly below?: number;
  /** The rear end of the blank, Z in mm; only for feeds behind the blank. */
  readonly rear?: number;
  /** A plain cut below a contour that is no fault; stored because later moves may change the verdict. */
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
  /** True where the values of that operation intend it. */
  readonly isAsked?: true;
}

/** The comparison of a blank stated during the run with the stock there, mm². */
export interface StatedProof {
  readonly step: number;
  readonly block: number;
  readonly what: string;
  /** Stock outside the stated outline, removed in an unknown way. */
  readonly missingArea: number;
  /** Area of the stated outline where the stock had already been cut. */
  readonly extraArea: number;
}

/** A piece is in front of the held part, a ring around it, a slug inside it. */
export type LooseShape = "piece" | "ring" | "slug";

/** A piece that no longer hangs together with the clamped end. It has left the stock. */
export interface LoosePiece {
  /** Index of the step after it came off. */
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
  /** Stock removed by feed moves; from `unlooked` on by rapids as well. */
  readonly cut: number;
  /** Roughing passes and passes of a thread that touched no stock. */
  readonly airPasses: number;
  /** The deepest roughing pass in the stock against the allowed depth, mm; null without roughing. */
  readonly deepest: Depth | null;
  /** Whether a holder touched the stock or the clamping; unknown when a tool that moved has none. */
  readonly holder: "clear" | "contact" | "unknown";
  /**
   * From this step on, contour damage, rapids in stock and holder contacts were not checked, because there were too
   * many; null: all were checked.
   */
  readonly uncheckedFrom: { readonly step: number; readonly block: number } | null;
  readonly unproved: readonly UnsimulatedBlock[];
  readonly stated: readonly StatedProof[];
  /** Pieces that came off the held part, in the order of the run; they have left the stock. */
  readonly loose: readonly LoosePiece[];
  /** Where the outside is turned away up to the rear end; null: enough is left to grip. */
  readonly unheld: Unheld | null;
  readonly remarks: readonly StockFinding<StockRemark>[];
  /** For each operation of the run, in its order. */
  readonly operations: readonly OperationProof[];
}

/** The operation or block that left nothing to grip at the rear end, with a point there. */
export interface Unheld {
  readonly step: number;
  readonly block: number;
  readonly operation: number | null;
  readonly place: Pt;
  /** The rear end of the blank, Z in mm. */
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

/** Material that an operation cut behind a machining limit. */
export interface BehindLimit {
  readonly limit: MachiningLimit;
  /** mm² of the half plane. */
  readonly area: number;
  /** The largest piece of it, a point inside, and the first move that cut it. */
  readonly ring: Ring;
  readonly place: Pt;
  readonly step: number;
  readonly block: number;
  /** True when roughing ran as well, but cut nothing there. */
  readonly finishing: boolean;
}

/** Missing material at the crest of a thread, mm, and the nominal place of that crest. */
export interface MissingCrest {
  readonly missing: number;
  /** The thread is on a face: the material is missing along Z. */
  readonly inFace: boolean;
  readonly z: number;
  readonly r: number;
}

/** The path of a thread, to find its overrun. */
export interface ThreadWay {
  readonly crest: readonly Pt[];
  /** Where the tip stops. */
  readonly stop: Pt;
  /** Unit direction out of the material. */
  readonly openSide: Pt;
}

/** The effect of one operation on the stock. */
export interface OperationProof {
  /** Stock that its feed moves removed, mm² of the half plane. */
  readonly cut: number;
  /** Roughing passes and passes of a thread that touched no stock. */
  readonly airPasses: number;
  /** For a thread, before its first pass; null where its crest is complete. */
  readonly crest: MissingCrest | null;
  /** Null for operations other than threads. */
  readonly thread: ThreadWay | null;
  /** The deepest roughing pass, along the infeed direction, against the greatest infeed; null without roughing. */
  readonly deepest: Depth | null;
  /**
   * The smoothing or finishing cut that exceeds the oversize plus one infeed, square to its path; null where none does.
   */
  readonly thickest: Depth | null;
  /** Material cut behind each crossed machining limit. */
  readonly behindLimits: readonly BehindLimit[];
  /** Where the insert is inside the stock at the start of the operation; null where it is clear. */
  readonly startInMaterial: Pt | null;
  /** True when an error prevented its path, or there was no stock: cutting nothing is then not reported. */
  readonly hasFailed: boolean;
  /** The sign or order of a dimension is questioned: tool and stock issues follow from that. */
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
