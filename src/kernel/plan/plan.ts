import type { Issue, Reason } from "./issue.ts";
import type { FeedUnit, Move } from "./move.ts";
import type { Pt, Ring, Segment } from "../geometry/point.ts";
import type { Tool } from "./tool.ts";
import type { Feed, Length } from "../units.ts";

/** Input of a plan besides the cycle's own values. */
export interface PlanContext {
  readonly tool: Tool;
  /** Theoretical tip at the cycle call. */
  readonly start: Pt;
  readonly feedUnit: FeedUnit;
  /** The value of FAUTO: the feed of the tool call; null if none was given. */
  readonly autoFeed: Feed | null;
  /** Outlines of the stock at the call; null if it is unknown after earlier cuts. */
  readonly stock: readonly Ring[] | null;
  /** True if blank update is active (FUNCTION TURNDATA BLANK): roughing leaves out passes that cut air. */
  readonly skipsAirPasses?: boolean;
  /**
   * Undrilled material: outlines, and the Z from which on they are solid. `isBored`: a bore in them may be wider by
   * now, so that they are reliable only on the axis. Absent if unknown.
   */
  readonly solid?: { readonly rings: readonly Ring[]; readonly below: number; readonly isBored: boolean } | null;
  /**
   * Outlines of the stated blank, whatever has been cut of it: there is no material outside. Absent if none is stated.
   */
  readonly blank?: readonly Ring[] | null;
}

/** The stock that a path may depend on: a control only knows an updated blank, whatever BLK FORM says. */
export const tracedStock = ({ stock, skipsAirPasses }: PlanContext): readonly Ring[] | null =>
  skipsAirPasses ? stock : null;

/**
 * A stretch of the finishing path, and the reason why the insert cannot go deeper there (null: it is on the contour).
 */
export interface Reach {
  readonly path: Segment;
  readonly reason: Reason | null;
}

/** How a thread is cut. Lengths mm. */
export interface ThreadPlan {
  /** From one groove to the next; with several starts the lead divided by their number. */
  readonly pitch: Length;
  /** Travel per spindle revolution. */
  readonly lead: Length;
  readonly starts: number;
  /** Depth of each pass; the last one is the thread depth. */
  readonly depths: readonly Length[];
  /** Setback of a pass along the thread per mm of missing depth. */
  readonly slope: number;
  /** Direction out of the material along the infeed, part space. */
  readonly out: Pt;
  /** The area above the crest, up to any stock: a thread leaves the stock there between its grooves. */
  readonly above: Ring;
  /** The crest from start to end of the thread, part space: the surface that has to exist before the thread is cut. */
  readonly crest: readonly Pt[];
  /** Stop position of the tip behind the end in the last pass, part space. */
  readonly end: Pt;
  readonly runIn: Length;
  /** The lower side of the insert in a groove, relative to the tip: along the thread and out of the material. */
  readonly side: readonly { readonly u: number; readonly v: number }[];
}

/** A machining limit: a plane across the spindle axis (z) or a cylinder (r), mm, and its side that must not be cut. */
export interface MachiningLimit {
  /** The input field of the limit. */
  readonly at: string;
  readonly axis: "z" | "r";
  readonly value: number;
  /** 1: greater values are behind the limit. */
  readonly behind: 1 | -1;
}

/** Residual material that the values of a cycle ask for. */
export interface IntendedResidual {
  readonly oversize: boolean;
  /** True if the corner keeps the radius of the insert. */
  readonly corner: boolean;
}

/** Result of a cycle's values: moves and issues. Everything that can be planned is planned. */
export interface Plan {
  /** The tool as adapted by the cycle (Q499 = 2 mirrors the tip); absent if unchanged. */
  readonly tool?: Tool;
  readonly moves: readonly Move[];
  readonly issues: readonly Issue[];
  /** Finished contour in machining direction, part space, arcs kept. */
  readonly contour: readonly Segment[];
  /**
   * True when passes run along the contour: the depth of a cut is then measured square to its path, like that of a
   * finishing cut.
   */
  readonly isParallel?: boolean;
  /**
   * Number of roughing passes at distinct levels, and the infeed after division (the greatest of several). For plunges
   * side by side: the number of bites, and the deepest one.
   */
  readonly passes: number;
  readonly infeed: Length;
  /** The area that a perfect cycle removes: between contour and start point (polygon, arcs flattened to CHORD). */
  readonly area: Ring;
  /** The finished part as far as this cycle knows it (polygon): no tool may cut into it. */
  readonly part: Ring;
  /**
   * Direction (unit offset) out of the material: in this direction from any position on the path, the space is free for
   * the tool.
   */
  readonly openSide: Pt;
  /** The deepest path of this tool along the drawn contour; explains residual material. */
  readonly reach: readonly Reach[];
  /** The same along the contour with oversize: material above this path is not part of the oversize. */
  readonly oversizeReach: readonly Reach[];
  /** The greatest infeed that the values allow, mm; 0 if they set none. */
  readonly maxInfeed: Length;
  /** The oversize that the values leave on the radius and along Z, mm; absent when the cycle has none. */
  readonly oversize?: { readonly r: number; readonly z: number };
  /** Residual material that the values ask for; absent if none. */
  readonly intendedResidual?: IntendedResidual;
  /** Threads only. */
  readonly thread?: ThreadPlan;
  /** The deepest path without machining limits; absent if there are none. */
  readonly unlimited?: readonly Reach[];
  /** Machining limits; absent if there are none. */
  readonly limits?: readonly MachiningLimit[];
}
