import type { Move } from "../plan/move.ts";
import type { Pt, Ring } from "../geometry/point.ts";
import type { Tool } from "../plan/tool.ts";
import type { Length } from "../units.ts";

/** Spindle set-up: constant speed in rpm, or constant cutting speed in m/min with a limit in rpm. */
export type Spindle =
  | { readonly kind: "constant"; readonly speed: number }
  | { readonly kind: "surface"; readonly cuttingSpeed: number; readonly limit: number };

/** Why the spindle does not turn as a cut requires: it is stopped, has no speed, or turns in the wrong direction. */
export interface SpindleFault {
  readonly how: "stopped" | "noSpeed" | "hand";
  /** Number of the block that stopped it or set its direction; null where none has. */
  readonly by: number | null;
}

/** A hole that has to exist before the tool feeds in, such as that of a tap. */
export interface NeededHole {
  /** Least radius of a hole for this tool, mm. */
  readonly radius: Length;
  /** Usual radius of the drilled hole, mm. */
  readonly drill: Length;
}

/**
 * One motion of a running program: a move with its start, tool and block. Simulation, animation, time and report share
 * this list.
 */
export interface Step {
  readonly from: Pt;
  readonly move: Move;
  readonly tool: Tool;
  /** Number of the executed block (the cycle call for moves of a cycle). */
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
   * The block whose rapid brought the tool to `from` from an unknown place; absent if the path there is a step or a
   * feed.
   */
  readonly positionedBy?: number;
  /** Of a feed move outside cycles: cut along a compensated contour, or marked as intended by the program. */
  readonly intent?: "compensated" | "meant";
  /**
   * Set if the step feeds while the spindle certainly does not turn as required: a fault as soon as it meets material.
   */
  readonly spindleFault?: SpindleFault;
  /** The hole that the step feeds through. */
  readonly hole?: NeededHole;
}

/** A blank that a program states while it runs: the outline of the stock at a step. */
export interface StatedBlank {
  /** Index of the first step after it. */
  readonly step: number;
  readonly block: number;
  /** As the program spells it. */
  readonly what: string;
  readonly rings: readonly Ring[];
  /** File of the called program that contains it; absent for the program itself. */
  readonly file?: string;
}

/**
 * A block that was read and not simulated although it can change the path or the stock: everything from its step on is
 * unverified.
 */
export interface UnsimulatedBlock {
  /** Index of the first step after it. */
  readonly step: number;
  /** Number of the block; null when it concerns the whole program. */
  readonly block: number | null;
  /** As the program spells it: "CYCL DEF 19", "M91", "CALL PGM". */
  readonly what: string;
  /** File of the called program that contains it; absent for the program itself. */
  readonly file?: string;
}
