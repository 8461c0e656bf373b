import type { Issue, Reason } from "./issue.ts";
import type { FeedUnit, Move } from "./move.ts";
import type { Pt, Ring, Segment } from "../geometry/point.ts";
import type { Tool } from "./tool.ts";
import type { Feed, Length } from "../units.ts";

/** What a plan needs beside the cycle's own values. */
export interface Setting {
  readonly tool: Tool;
  /** Theoretical tip at the cycle call. */
  readonly start: Pt;
  readonly feedUnit: FeedUnit;
  /** What FAUTO stands for: the feed of the tool call; null when none was given. */
  readonly autoFeed: Feed | null;
  /** Outlines of what stands in the chuck at the call; null where earlier cuts have left nobody knows what. */
  readonly stock: readonly Ring[] | null;
  /** True where that stock is traced (FUNCTION TURNDATA BLANK): roughing leaves out passes that touch nothing of it. */
  readonly leavesOutAir?: boolean;
  /**
   * What nobody has drilled yet: outlines, and the Z from which on they are solid. `isBored`: a bore in them may be
   * wider by now, so that they tell of the axis only. Absent where nobody knows.
   */
  readonly solid?: { readonly rings: readonly Ring[]; readonly below: number; readonly isBored: boolean } | null;
  /**
   * Outlines that nothing stands outside of: the blank that is stated, whatever has been cut of it. Absent where none
   * is.
   */
  readonly blank?: readonly Ring[] | null;
}

/** The stock that a path may hang on: a control knows none but one that is traced, whatever BLK FORM says. */
export const tracedStock = ({ stock, leavesOutAir }: Setting): readonly Ring[] | null => (leavesOutAir ? stock : null);

/**
 * A stretch of the finishing path, with what keeps the insert from going deeper there (null: it lies on the contour).
 */
export interface Reach {
  readonly path: Segment;
  readonly reason: Reason | null;
}

/** How a thread is cut. Lengths mm. */
export interface ThreadPlan {
  /** From one groove to the next; of several starts the part of the lead that each has. */
  readonly pitch: Length;
  /** Way in one turn of the spindle. */
  readonly lead: Length;
  readonly starts: number;
  /** Depth of each pass, the last one that of the thread. */
  readonly depths: readonly Length[];
  /** How far a pass lies back along the thread for each mm that is missing in depth. */
  readonly slope: number;
  /** Out of the material along the infeed, part space. */
  readonly out: Pt;
  /** The room over the crest, as far as any stock reaches: what stands there the thread leaves between its grooves. */
  readonly above: Ring;
  /**
   * The crest from the beginning of the thread to its end, part space: the surface that has to stand before it is cut.
   */
  readonly crest: readonly Pt[];
  /** Where the tip of the last pass comes to a stop behind the end, part space. */
  readonly end: Pt;
  readonly runIn: Length;
  /** The lower side of the insert in a groove, from the tip: along the thread and out of the material. */
  readonly side: readonly { readonly u: number; readonly v: number }[];
}

/**
 * A machining limit: a plane across the spindle axis (z) or a cylinder (r), mm, and the side of it that is not to be
 * cut.
 */
export interface MachiningLimit {
  /** The field it was given in. */
  readonly at: string;
  readonly axis: "z" | "r";
  readonly value: number;
  /** 1: greater values lie behind it. */
  readonly behind: 1 | -1;
}

/** What a cycle is asked to leave: it stays on purpose. */
export interface LeftOnPurpose {
  readonly oversize: boolean;
  /** A corner as round as the insert. */
  readonly corner: boolean;
}

/** What a cycle makes of its values: moves plus issues, and what can be planned is planned. */
export interface Plan {
  /** The tool as the cycle adapts it (Q499 = 2 mirrors the tip); absent when it works as it is. */
  readonly tool?: Tool;
  readonly moves: readonly Move[];
  readonly issues: readonly Issue[];
  /** Finished contour in machining direction, part space, arcs kept. */
  readonly contour: readonly Segment[];
  /** True when passes run along the contour: the depth of a cut is then square to its path, as of a finishing cut. */
  readonly isParallel?: boolean;
  /**
   * Roughing passes at distinct levels, and the infeed as divided: of several, the greatest. Of plunges side by side:
   * the bites they take, and the deepest one.
   */
  readonly passes: number;
  readonly infeed: Length;
  /**
   * What this cycle takes away when it is perfect: between contour and start point (polygon, arcs flattened to CHORD).
   */
  readonly area: Ring;
  /** The finished part as far as this cycle knows it (polygon): nothing may cut here. */
  readonly part: Ring;
  /**
   * Direction (unit offset) out of the material: whatever lies that way of a position on the path is free for the tool.
   */
  readonly openSide: Pt;
  /** The deepest path of this tool along the drawn contour; explains what stays. */
  readonly reach: readonly Reach[];
  /** The same along the contour grown by the oversize: what stays above it is no oversize. */
  readonly kept: readonly Reach[];
  /** The greatest infeed that the values allow, mm; 0 when they set none. */
  readonly most: Length;
  /** The oversize that the values leave on the radius and along Z, mm; absent when the cycle has none. */
  readonly oversize?: { readonly r: number; readonly z: number };
  /** What the values ask it to leave; nothing where absent. */
  readonly asked?: LeftOnPurpose;
  /** Of a thread. */
  readonly thread?: ThreadPlan;
  /** The deepest path as it would run without machining limits; absent when there are none. */
  readonly unlimited?: readonly Reach[];
  /** Machining limits; absent when there are none. */
  readonly limits?: readonly MachiningLimit[];
}
