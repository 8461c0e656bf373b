import type { Severity } from "../../kernel/plan/issue.ts";
import type { FeedUnit } from "../../kernel/plan/move.ts";

/** Rules that a control holds a program to, each by what breaks it. */
export type ControlRule = "signOfAngle" | "zeroBehindCorner" | "emptyCentre" | "sideOnArc" | "toolCallCompensated";

/**
 * What can be wrong when a program runs, beside its text (`nc`) and its cycles (`kernel`): code and data, no sentences.
 */
interface Data {
  /** The block is understood by the reader and left out by the simulation. */
  notSimulated: { what: string };
  /** It can move the path or the stock: nothing is proved from here on. */
  notProved: { what: string };
  cycleNotSimulated: { cycle: number; name: string };
  /** A cycle call without a definition before it. */
  noCycleDefined: {};
  noToolCalled: {};
  toolUnknown: { tool: string };
  notInTurnMode: {};
  /** RL or RR is in force where the control wants R0: at a cycle call, or in PS before an APPR. */
  compensationActive: { side: "RL" | "RR" };
  /** A cutting feed of 0, as it is written, or FAUTO without a feed in TOOL CALL. */
  feedZero: { word: string };
  /** A feed that can be run and that nobody means. */
  feedUnlikely: { feed: number; unit: FeedUnit };
  /** A bore deeper than the edges of its drill are long. */
  drillTooShort: { depth: number; edges: number };
  /** Another pitch in the cycle than that of the tap. */
  pitchOfTap: { pitch: number; tap: number };
  cycleNeverCalled: { cycle: number };
  /** Motion or a call behind the end of the program. */
  neverReached: { by: string };
  /** A parameter that the cycle does not have, or one that stands twice. */
  parameterForeign: { name: string; cycle: number };
  /**
   * The list of a cycle ends where older software ended it; `filled` is what the control fills in, as words of the
   * list.
   */
  listOfOlderSoftware: { cycle: number; filled: readonly string[] };
  /** The program runs on into the label of a contour. */
  runsIntoLabel: { label: string };
  /** The first block of a contour does not name both coordinates. */
  contourStartIncomplete: { axis: string };
  /** APPR without RL or RR: the contour behind it is not compensated. */
  approachUncompensated: { form: string };
  labelMissing: { label: string };
  labelTwice: { label: string };
  labelNotClosed: { label: string };
  contourNotNamed: { cycle: number };
  /** SEL CONTOUR names a file, and the run has this program only. */
  contourInFile: { file: string };
  /** Several contours that a formula or CONTOUR DEF joins: a turning cycle takes one. */
  contoursJoined: { cycle: number; joined: string };
  feedMissing: {};
  spindleMissing: {};
  /** Constant surface speed without SMAX on a path that comes near the axis: to this diameter, mm, in this block. */
  speedUnlimited: { diameter: number; block: number };
  /** More than the material allows, m/min, or than the machine can, rpm. */
  speedUnlikely: { speed: number; most: number; of: "material" | "machine" };
  /** The tool turns beside the centre by so many mm in Y. */
  offCentre: { y: number };
  /** TOOL CALL with an index that the table does not have; `rows` are those of the same tool. */
  toolIndexUnknown: { tool: string; rows: readonly string[] };
  /** A contour begins with a block that counts from a point before it. */
  firstElement: { word: string };
  /** A printed rule of the control; `word` is what breaks it. */
  controlRule: { rule: ControlRule; word: string };
  parameterUnset: { name: string };
  divisionByZero: {};
  notFinite: { text: string };
  /**
   * `; CLAMPING …`: words that were not understood, the rest counts; words without which nothing is known; a second
   * one.
   */
  clampingUnread: { what: string };
  clampingIncomplete: { words: string };
  clampingTwice: {};
  /** Jaws or collet are stated where there is nothing of the blank at their ⌀, or more than it. */
  clampingMisses: { diameter: number };
  blankMissing: {};
  blankNotTurned: { form: string };
  blankImpossible: {};
  /**
   * A box turns: the cylinder round its corners is the stock, and there is material all round within the inner diameter
   * only.
   */
  boxTurned: { outer: number; inner: number };
  /** The outline of FUNCTION TURNDATA BLANK is the stock, since BLK FORM gives none that is turned. */
  blankTaken: { what: string };
  /** It is, though it has more than BLK FORM, mm². */
  blankAdds: { what: string; area: number };
  /** Roughing leaves out what touches nothing of the blank that is traced; other cuts in the air are run here. */
  blankTraced: {};
  poleMissing: {};
  startUnknown: {};
  /** A measure of the blank that somebody has set, and the contour that it does not agree with: ⌀ or Z, mm. */
  blankAgainstContour: {
    place: "outside" | "bore" | "length" | "allowance" | "thread";
    contour: number;
    blank: number;
    other?: string;
    nearest: number;
  };
  /** An element of a free contour that what is given does not determine, or not without contradiction. */
  freeChosen: {};
  freeUnsolved: { form: string };
  arcImpossible: {};
  radiusCompensation: { side: "RL" | "RR" };
  /**
   * RL or RR with a turning tool whose tip orientation names no side: the direction of the compensation is not defined.
   */
  compensationUndefined: { side: "RL" | "RR"; orientation: number };
  /** RL to RR or back without R0 between. */
  sideChanged: {};
  /** APPR without an element behind it, DEP without one before it. */
  approachWithoutContour: { form: string };
  /** DZL and DXL of the table: the control counts with them, so the tip stays on the path. */
  lengthDelta: { tool: number };
  /** The path is that of a tool of radius 0. */
  toolRadiusUnknown: { tool: string };
  /** The words of this block are recalled from the manual, not checked against a printed page. */
  wordsRecalled: { what: string };
  programEndMissing: {};
  tooManyBlocks: { limit: number };
  tooManyMoves: { limit: number };
  contourTooLong: { limit: number };
  tooManyOperations: { limit: number };
  /** Findings of one code that are not listed, from this place on. */
  moreAlike: { code: string; count: number };
  callsTooDeep: { limit: number };
  programsTooDeep: { limit: number };
  /** M2 or M30 in a program that is called. */
  endInCalled: { word: string };
  /** A program that is called and was not opened with this one. */
  programNotOpened: { file: string };
  /** FN 14: the control stops with this error; null when its number is not known. */
  errorRaised: { error: number | null };
  /** CALL SELECTED PGM without SEL PGM before it. */
  programNotSelected: {};
}

export type ProgramCode = keyof Data;
export type ProgramIssue = {
  [C in ProgramCode]: {
    readonly code: C;
    readonly severity: Severity;
    readonly at?: string;
    readonly data: Readonly<Data[C]>;
  };
}[ProgramCode];

/** Makes one issue; the compiler checks that the data fit the code. */
export function programIssue<C extends ProgramCode>(
  code: C,
  severity: Severity,
  data: Data[C],
  at?: string,
): ProgramIssue {
  return (at === undefined ? { code, severity, data } : { code, severity, at, data }) as ProgramIssue;
}
