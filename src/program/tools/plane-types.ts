import type { ApproachRequest, ApproachShape, NamedPoints } from "../../kernel/plane/approach.ts";
import type { ContourCut, ApproachFix } from "../../kernel/plane/approach-check.ts";
import type { FeedUnit } from "../../kernel/plan/move.ts";
import type { PlanePoint, PlaneSegment, Side } from "../../kernel/plane/plane.ts";
import type { Turn } from "../../kernel/geometry/point.ts";
import type { DrillType } from "../../kernel/plan/tool.ts";
import type { ApproachForm } from "../../nc/words.ts";
import type { Transform } from "./coordinates-frame.ts";

/**
 * How a control moves in the tool axis with APPR and DEP: "TNC 640" in the plane first, then in the axis; "TNC7" both
 * at once.
 */
export type Control = "TNC 640" | "TNC7";

/** A position of a mill, mm: its centre in the plane, its end in the axis. `z` is null until a block names it. */
export interface Spot {
  readonly x: number;
  readonly y: number;
  readonly z: number | null;
}

/** One motion of a milling program. An arc with different z at its ends is a helix. */
export interface PlaneStep {
  readonly kind: "rapid" | "feed" | "arc";
  readonly from: Spot;
  readonly to: Spot;
  readonly centre?: PlanePoint;
  readonly turn?: Turn;
  /**
   * For an arc in a plane that contains the tool axis: the centre in the axes of that plane, the turn from its first to
   * its second.
   */
  readonly side?: {
    readonly plane: "YZ" | "ZX";
    readonly centre: { readonly x?: number; readonly y?: number; readonly z?: number };
    readonly turn: Turn;
  };
  /** Absent on a rapid. */
  readonly feed?: number;
  readonly feedUnit?: FeedUnit;
  /** Tool radius, mm; 0 when unknown. */
  readonly radius: number;
  /** Number of the block, and its index in the parsed program. */
  readonly block: number;
  readonly index: number;
  readonly seconds: number;
  /** Number of turning steps before it: gives the order in a program that turns and mills. */
  readonly turned: number;
}

/** One executed APPR or DEP. */
export interface ApproachRun {
  readonly block: number;
  readonly index: number;
  readonly form: ApproachForm;
  readonly shape: ApproachShape;
  readonly departing: boolean;
  readonly side: Side;
  /** The working plane: X/Y of a mill, or Z/X of a turning tool. */
  readonly plane: "XY" | "ZX";
  /**
   * PS, PH, PA, PE, PN in the plane (turning: x is Z, y is the radius). XY: tool centre. ZX: the theoretical tip, whose
   * nose centre runs on the compensated path.
   */
  readonly points: NamedPoints;
  readonly toolRadius: number;
  /** Arc of CT and LCT, degrees; its centre like the points. */
  readonly arc: {
    readonly centre: PlanePoint;
    readonly radius: number;
    readonly angle: number;
    readonly turn: Turn;
  } | null;
  /** Inputs of its calculation, for a dialog that tests other values; in the path of the tool centre. */
  readonly request: ApproachRequest;
  /** Its programmed contour. */
  readonly contour: readonly PlaneSegment[];
  /** Vector from the tool centre to the programmed point: zero for a mill. */
  readonly tip: PlanePoint;
  /** Offset of the program datum from the workpiece datum, in the plane. */
  readonly datum: PlanePoint;
  /** Mirror, rotation and scale of the program coordinates. */
  readonly transform: Transform;
  /** CC at the block. */
  readonly pole: PlanePoint | null;
  /** Feed before the block, in its unit; "rapid", or null when none was programmed. */
  readonly feedBefore: number | "rapid" | null;
  /** Where the path of the tool centre cuts into the contour, and a value that avoids it. */
  readonly cut: ContourCut | null;
  readonly free: ApproachFix | null;
}

/** Data of a milling tool that the path needs, mm. */
export interface Mill {
  readonly T: number;
  readonly NAME: string;
  readonly R: number;
  readonly DR?: number;
  /** Type of a tool that can drill on the spindle axis. */
  readonly TYPE?: DrillType;
  /** Point angle, degrees. */
  readonly "T-ANGLE"?: number;
  /** Cutting edge length. */
  readonly LCUTS?: number;
  readonly PITCH?: number;
  /** Length of the point, where its angle is not stated. */
  readonly PL?: number;
}
