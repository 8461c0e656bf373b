import type { Clamping } from "../../kernel/area/clamping.ts";
import type { CornerElement } from "../../kernel/contour/corner.ts";
import type { Ring, Segment } from "../../kernel/geometry/point.ts";
import type { Spindle } from "../../kernel/time/step.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { length, type Feed, type Length } from "../../kernel/units.ts";
import type { Compensation, Label } from "../../nc/words.ts";
import type { BoxCorner } from "./blank-form.ts";
import { NO_TRANSFORM, type Transform } from "../tools/coordinates-frame.ts";
import type { UnknownReason } from "../values/known-values.ts";
import type { SpindleTurns } from "../machine/machine-data.ts";
import type { Unit } from "./units.ts";
import { NOWHERE, type MillPlane, type Pole, type Position } from "./path.ts";

type Correction = NonNullable<Tool["correction"]>;

/** Offset of the program datum from the workpiece datum, mm; X as a distance, never as a diameter. */
export interface Datum {
  readonly x: Length;
  readonly y: Length;
  readonly z: Length;
}

export const NO_SHIFT: Datum = { x: length(0), y: length(0), z: length(0) };

/** A cycle definition waiting for its call, with its numbers at definition time. */
export interface Defined {
  readonly index: number;
  readonly cycle: number;
  readonly values: ReadonlyMap<string, number | "auto" | null>;
  /** Parameters without a number, for a reported reason. */
  readonly unknownParameters: ReadonlySet<string>;
  /** Program that the call runs instead of a cycle; null when its name is unknown. */
  readonly program?: string | null;
}

/** Source of a contour: a label of a text, or the whole text. */
export interface ContourSource {
  readonly unit: Unit;
  readonly label: Label | null;
}

/** Several contours joined by a rule of milling: the operation, and its block. */
export interface JoinedContours {
  readonly joined: string;
  readonly index: number;
}

/** A path element that waits for a possible corner block. */
export interface PendingElement {
  readonly segment: Segment;
  readonly feed: Feed | null;
  readonly index: number;
  readonly corner: { readonly element: CornerElement; readonly feed: Feed | null; readonly index: number } | null;
  /** Its number, from 1, in the current contour. */
  readonly element: number;
}

/** A blank that is no body of revolution about the spindle axis: a box, a file, or another axis. */
export type NonTurnedBlank =
  | { readonly kind: "box"; readonly index: number; readonly corners: readonly [BoxCorner, BoxCorner] }
  | {
      readonly kind: "file" | "otherAxis";
      readonly index: number;
      readonly form: string;
    };

/** Modal state of milling, mm. */
export interface Milling {
  /** Radius of the tool with its delta; null when no table and no TOOL DEF names it. */
  readonly radius: number | null;
  readonly tool: string;
  /** True while the tool axis is not Z, so that the plane is not X/Y. */
  readonly otherAxis: boolean;
  /** Upper side of the blank. */
  readonly top: number | null;
}

/** Tool position between two blocks. X is a diameter, mm. Immutable: every move replaces it. */
export interface ToolPosition {
  readonly at: Position;
  /** False after a tool change until the axis is programmed again: the change leaves it anywhere. */
  readonly sure: { readonly x: boolean; readonly z: boolean };
  /** Block of the rapid from an unknown position to here; null once the tool has moved on. */
  readonly positionedBy: number | null;
  /** Block that moved the tool to machine home, until the next tool change: a cut from there is unverified. */
  readonly homedBy: { readonly index: number; readonly what: string } | null;
  /** Whether the last point named both coordinates of its plane; null where this is not checked. */
  readonly isWhole: boolean | null;
  /** Why a coordinate became unknown: a block not simulated, or a reported fault. */
  readonly lostReason: UnknownReason | null;
  /** Element that waits for a possible corner block. */
  readonly pendingElement: PendingElement | null;
  /** The last path element, for tangential arcs. */
  readonly last: Segment | null;
  /** The position of a mill, as programmed. */
  readonly mill: Position;
  /** Last milling motion, for a tangential arc in another plane; its arc, null for a line. */
  readonly milled: {
    readonly from: Position;
    readonly to: Position;
    readonly plane: MillPlane;
    readonly segment: Segment | null;
  } | null;
}

/** Progress of a run. */
interface Count {
  readonly operations: number;
  readonly steps: number;
}

/** Bored part of a blank at some progress of the run; `below` as the plan of a cycle uses it. */
interface Bored extends Count {
  /** Progress at which the blank was stated. */
  readonly since: Count;
  readonly below: number;
  readonly isBored: boolean;
}

/** Modal state between two blocks, mm. Immutable: a block replaces it. */
export interface Modal {
  /** The program's unit of length. */
  readonly inch: boolean;
  readonly turning: boolean;
  /** Mode of FUNCTION MODE; null before one. */
  readonly mode: "TURN" | "MILL" | null;
  /** Active preset; null before one was named. */
  readonly preset: number | null;
  /** Datum of the program; all positions below are those of the workpiece. */
  readonly datum: Datum;
  /** Axes with an unknown shift: from a table, or from a parameter without a number. */
  readonly unknownDatum: readonly (keyof Datum)[];
  /** How coordinates are mirrored, turned and scaled about the datum. */
  readonly transform: Transform;
  /** RL or RR as programmed last. */
  readonly compensation: Compensation;
  readonly feed: Feed | null;
  /** Feed of the last positioning block, null for rapid; undefined before the first. */
  readonly lastFeed: Feed | null | undefined;
  readonly toolFeed: Feed | null;
  /** How the feed in force was written. */
  readonly feedWord: "F" | "FAUTO";
  /** Feed and unit checked last, so that a modal feed is checked once. */
  readonly judged: string;
  readonly perRevolution: boolean;
  readonly spindle: Spindle | null;
  /** Block that set it. */
  readonly spinBlock: number | null;
  /** An M function started it, or may have. */
  readonly turns: boolean;
  /** Reversed: M4 and its like. */
  readonly backwards: boolean;
  /** Spindle state at the last motion since its start. */
  readonly lastTurns: SpindleTurns | null;
  /**
   * Block of the last start or stop, null before any; number of unverified entries then; whether a cut was reported
   * since.
   */
  readonly spindleChange: { readonly index: number | null; readonly unproved: number; readonly told: boolean };
  /**
   * A speed not meant for turning: of TOOL CALL, which counts for a drill in the tool spindle, or one with a reported
   * fault.
   */
  readonly speedElsewhere: "toolCall" | "told" | null;
  /** Spindle direction of each tool at its first cycle, by tool number: an edge cuts in one direction only. */
  readonly spindleDirections: ReadonlyMap<number, boolean>;
  /** Tool position by a Y word in turning, mm from the centre; null before any. */
  readonly offsetY: number | null;
  readonly tool: Tool | null;
  /** Name of the last tool changed in; null before one. */
  readonly changedTo: string | null;
  /** True when a TOOL CALL named an unusable tool, which is reported already. */
  readonly toolRefused: boolean;
  readonly pole: Pole | null;
  /** Contours named by cycle 14, CONTOUR DEF or SEL CONTOUR. */
  readonly contours: readonly ContourSource[] | JoinedContours | "unknown";
  /** Missing file of SEL CONTOUR or CONTOUR DEF. */
  readonly contourFile: string | null;
  /** FUNCTION TURNDATA CORR of the tool in the spindle, mm. */
  readonly corrections: { readonly TCS?: Correction; readonly WPL?: Correction };
  /** Program of SEL PGM; without a name where that is unknown. */
  readonly selectedProgram: { readonly name: string | null } | null;
  readonly defined: Defined | null;
  /** M89: the defined cycle is called behind every positioning block. */
  readonly callsBehindMoves: boolean;
  readonly blank: readonly Ring[];
  /** Clamping, and the block that states it. */
  readonly clamping: { readonly index: number; readonly made: Clamping } | null;
  /** Progress of the run when the blank was stated. */
  readonly blankSince: Count;
  /** Bored part of that blank at the last cycle call. */
  readonly bored: Bored | null;
  /** File of the program that states it, null for the main program; undefined before a BLK FORM. */
  readonly blankIn: string | null | undefined;
  /** A blank that is no body of revolution: its stock is chosen when turning starts. */
  readonly nonTurnedBlank: NonTurnedBlank | null;
  readonly mill: Milling;
}

/** Before the first block. */
export const AT_START: Modal = {
  inch: false,
  turning: false,
  mode: null,
  preset: null,
  datum: NO_SHIFT,
  unknownDatum: [],
  transform: NO_TRANSFORM,
  compensation: "R0",
  feed: null,
  lastFeed: undefined,
  toolFeed: null,
  feedWord: "F",
  judged: "",
  perRevolution: false,
  spindle: null,
  spinBlock: null,
  turns: false,
  backwards: false,
  lastTurns: null,
  spindleChange: { index: null, unproved: 0, told: false },
  speedElsewhere: null,
  spindleDirections: new Map(),
  offsetY: null,
  tool: null,
  changedTo: null,
  toolRefused: false,
  pole: null,
  contours: [],
  contourFile: null,
  corrections: {},
  selectedProgram: null,
  defined: null,
  callsBehindMoves: false,
  blank: [],
  clamping: null,
  blankSince: { operations: 0, steps: 0 },
  bored: null,
  blankIn: undefined,
  nonTurnedBlank: null,
  mill: { radius: null, tool: "", otherAxis: false, top: null },
};

/** Before the first move. */
export const NOT_PLACED: ToolPosition = {
  at: NOWHERE,
  sure: { x: false, z: false },
  positionedBy: null,
  homedBy: null,
  isWhole: null,
  lostReason: null,
  pendingElement: null,
  last: null,
  mill: NOWHERE,
  milled: null,
};
