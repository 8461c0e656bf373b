import type { Move } from "../plan/move.ts";
import type { Pt, Ring } from "../geometry/point.ts";
import type { Tool } from "../plan/tool.ts";
import type { Length } from "../units.ts";

/** Spindle set-up: constant speed in rpm, or constant cutting speed in m/min with a limit in rpm. */
export type Spindle =
  | { readonly kind: "constant"; readonly speed: number }
  | { readonly kind: "surface"; readonly cuttingSpeed: number; readonly limit: number };

/** Why the spindle does not turn as a cut needs it: it stands, has no speed, or turns the other way round. */
export interface Idle {
  readonly how: "stopped" | "noSpeed" | "hand";
  /** Number of the block that stopped it or set its direction; null where none has. */
  readonly by: number | null;
}

/** A hole that has to be there before the tool comes, such as that of a tap. */
export interface NeededHole {
  /** mm; what is narrower is no hole for this tool. */
  readonly radius: Length;
  /** The hole that is drilled for it, mm. */
  readonly drill: Length;
}

/**
 * One motion of a running program: a move, where it starts, with which tool, from which block. This list is what the
 * simulation, the animation, the time and the report share.
 */
export interface Step {
  readonly from: Pt;
  readonly move: Move;
  readonly tool: Tool;
  /** Number of the block that is executed (the cycle call for moves of a cycle). */
  readonly block: number;
  /** Index into the operations of the run; null outside cycles. */
  readonly operation: number | null;
  /** Duration from feed, spindle and rapid rate. */
  readonly seconds: number;
  /** File of the called program whose block this is; absent for the program itself. */
  readonly file?: string;
  /** Line of that block in its file, from 1. */
  readonly line?: number;
  /**
   * The block that brought the tool to `from` at rapid, from where nobody knows; absent where the way there is a step
   * or a feed.
   */
  readonly broughtBy?: number;
  /** Of a feed move outside cycles: cut along a compensated contour, or said by the program to be meant. */
  readonly intent?: "compensated" | "meant";
  /** Where the step feeds while the spindle surely does not turn as it must: a fault as soon as it meets material. */
  readonly idle?: Idle;
  /** The hole that the step feeds through. */
  readonly hole?: NeededHole;
}

/** A blank that a program states while it runs: what stands in the chuck at a step, by its outline. */
export interface Stated {
  /** Index of the first step that comes after it. */
  readonly step: number;
  readonly block: number;
  /** As the program spells it. */
  readonly what: string;
  readonly rings: readonly Ring[];
  /** File of the called program that says it; absent for the program itself. */
  readonly file?: string;
}

/**
 * Something a program does that was read and not simulated although it can move the path or the stock: from its step on
 * nothing is proved.
 */
export interface Unproved {
  /** Index of the first step that comes after it. */
  readonly step: number;
  /** Number of its block; null when it concerns the whole program. */
  readonly block: number | null;
  /** As the program spells it: "CYCL DEF 19", "M91", "CALL PGM". */
  readonly what: string;
  /** File of the called program that says it; absent for the program itself. */
  readonly file?: string;
}
