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

/** How far the datum of the program stands from that of the workpiece, mm; X as a distance, never as a diameter. */
export interface Datum {
  readonly x: Length;
  readonly y: Length;
  readonly z: Length;
}

export const NO_SHIFT: Datum = { x: length(0), y: length(0), z: length(0) };

/** A cycle definition waiting for its call. Numbers as they were when the definition was reached. */
export interface Defined {
  readonly index: number;
  readonly cycle: number;
  readonly values: ReadonlyMap<string, number | "auto" | null>;
  /** Parameters without a number for a reason that has been told. */
  readonly troubled: ReadonlySet<string>;
  /** Program that the call runs in place of a cycle; null when nobody knows its name. */
  readonly program?: string | null;
}

/** Where a contour stands: behind a label of a text, or all of that text. */
export interface ContourSource {
  readonly unit: Unit;
  readonly label: Label | null;
}

/** Several contours that make one by a rule of milling: how they are joined, and the block that says so. */
export interface JoinedContours {
  readonly joined: string;
  readonly index: number;
}

/** A plain path element that waits for the corner behind it. */
export interface Held {
  readonly segment: Segment;
  readonly feed: Feed | null;
  readonly index: number;
  readonly corner: { readonly element: CornerElement; readonly feed: Feed | null; readonly index: number } | null;
  /** Its number in the contour that runs on from block to block, from 1. */
  readonly element: number;
}

/** A blank of another form: a box, a body in a file, or one round another axis. */
export type UnturnedBlank =
  | { readonly kind: "box"; readonly index: number; readonly corners: readonly [BoxCorner, BoxCorner] }
  | {
      readonly kind: "file" | "otherAxis";
      readonly index: number;
      readonly form: string;
    };

/** What is in force for a mill, mm. */
export interface Milling {
  /** Radius of the tool with its delta; null when no table and no TOOL DEF names it. */
  readonly radius: number | null;
  readonly tool: string;
  /** True while the tool axis is not Z, so that the plane is not X/Y. */
  readonly otherAxis: boolean;
  /** Upper side of the blank. */
  readonly top: number | null;
}

/**
 * Where the tool stands between two blocks. X is a diameter, mm. Never changed in place: every move puts a new one in
 * its place.
 */
export interface Whereabouts {
  readonly at: Position;
  /** False after a tool change until the axis is programmed again: nobody knows where the change left it. */
  readonly sure: { readonly x: boolean; readonly z: boolean };
  /** The block that brought the tool here at rapid, from where nobody knows; null once the tool has moved on. */
  readonly brought: number | null;
  /**
   * The block that took the tool home in machine coordinates, until the tool is changed: a cut from there is not
   * proved.
   */
  readonly home: { readonly index: number; readonly what: string } | null;
  /** Whether the last point was programmed with both coordinates of its plane; null where nobody asks. */
  readonly isWhole: boolean | null;
  /** Why a coordinate is not known any more, when a block that was not run or a fault that was told is the reason. */
  readonly lost: UnknownReason | null;
  /** An element that waits for the corner behind it. */
  readonly held: Held | null;
  /** The last path element, for tangential arcs. */
  readonly last: Segment | null;
  /** The position of a mill, as programmed. */
  readonly mill: Position;
  /**
   * What a mill ran last, for an arc that leaves it tangentially beside the plane of the tool axis; its arc, null for a
   * line.
   */
  readonly milled: {
    readonly from: Position;
    readonly to: Position;
    readonly plane: MillPlane;
    readonly segment: Segment | null;
  } | null;
}

/** How far a run has come. */
interface Count {
  readonly operations: number;
  readonly steps: number;
}

/** What had been bored of a blank up to a place of the run; `below` as the plan of a cycle asks for it. */
interface Bored extends Count {
  /** The place since which the blank stands as it is stated. */
  readonly since: Count;
  readonly below: number;
  readonly isBored: boolean;
}

/** What is in force between two blocks, mm. Never changed in place: a block puts a new one in its place. */
export interface Modal {
  /** The program's unit of length. */
  readonly inch: boolean;
  readonly turning: boolean;
  /** As FUNCTION MODE said; null while no block has. */
  readonly mode: "TURN" | "MILL" | null;
  /** The preset that counts; null before one was named. */
  readonly preset: number | null;
  /** Where the program counts from; all positions below are those of the workpiece. */
  readonly datum: Datum;
  /** Axes whose shift nobody knows: it stands in a table, or in a parameter without a number. */
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
  /** The feed and unit that were judged last, so that a modal feed is judged once. */
  readonly judged: string;
  readonly perRevolution: boolean;
  readonly spindle: Spindle | null;
  /** The block that says so. */
  readonly spunBy: number | null;
  /** An M function has started it, or may have. */
  readonly turns: boolean;
  /** It turns the other way round: M4 and its like. */
  readonly backwards: boolean;
  /** How it turned at the last motion since it was started. */
  readonly runsAs: SpindleTurns | null;
  /**
   * The block that started or stopped it last, null before any; how much was left unproved then; and whether a cut has
   * been blamed since.
   */
  readonly spun: { readonly index: number | null; readonly unproved: number; readonly told: boolean };
  /**
   * A speed that is none of turning: of TOOL CALL, which counts for a drill in the tool spindle, or one whose fault has
   * been told.
   */
  readonly speedElsewhere: "toolCall" | "told" | null;
  /** Which way round the spindle turned when a tool cut in a cycle first, by its number: an edge cuts one way only. */
  readonly ways: ReadonlyMap<number, boolean>;
  /** Where a Y word of turning has put the tool, mm from the centre; null before any. */
  readonly besideCentre: number | null;
  readonly tool: Tool | null;
  /** What the tool is called that was changed in last; null before one was. */
  readonly changedTo: string | null;
  /** True when a TOOL CALL named a tool that can not be used: that has been told. */
  readonly toolRefused: boolean;
  readonly pole: Pole | null;
  /** What cycle 14, CONTOUR DEF or SEL CONTOUR name. */
  readonly contours: readonly ContourSource[] | JoinedContours | "unknown";
  /** File that SEL CONTOUR or CONTOUR DEF names and that is not at hand. */
  readonly contourFile: string | null;
  /** FUNCTION TURNDATA CORR of the tool in the spindle, mm. */
  readonly corrections: { readonly TCS?: Correction; readonly WPL?: Correction };
  /** What SEL PGM names; without a name where it hangs on a value that nobody knows. */
  readonly selectedProgram: { readonly name: string | null } | null;
  readonly defined: Defined | null;
  /** M89: the defined cycle is called behind every positioning block. */
  readonly callsBehindMoves: boolean;
  readonly blank: readonly Ring[];
  /** What the work is held by, and the block that states it. */
  readonly clamping: { readonly index: number; readonly made: Clamping } | null;
  /** How many cycles had been called, and steps run, when the blank was as it is stated. */
  readonly blankSince: Count;
  /** What had been bored of that blank when a cycle was called last. */
  readonly bored: Bored | null;
  /** File of the program that states it, null for the one that was started; undefined before a BLK FORM. */
  readonly blankIn: string | null | undefined;
  /** A blank that is no body round the axis of the spindle: what stands for it shows when the program turns. */
  readonly unturned: UnturnedBlank | null;
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
  spunBy: null,
  turns: false,
  backwards: false,
  runsAs: null,
  spun: { index: null, unproved: 0, told: false },
  speedElsewhere: null,
  ways: new Map(),
  besideCentre: null,
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
  unturned: null,
  mill: { radius: null, tool: "", otherAxis: false, top: null },
};

/** Before the first move. */
export const NOT_PLACED: Whereabouts = {
  at: NOWHERE,
  sure: { x: false, z: false },
  brought: null,
  home: null,
  isWhole: null,
  lost: null,
  held: null,
  last: null,
  mill: NOWHERE,
  milled: null,
};
