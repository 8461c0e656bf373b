import type { Severity } from "../../kernel/plan/issue.ts";
import type { FeedUnit } from "../../kernel/plan/move.ts";

/** Rules of the control, named by their violation. */
export type ControlRule = "signOfAngle" | "zeroBehindCorner" | "emptyCentre" | "sideOnArc" | "toolCallCompensated";

/** Issues of a run, besides those of its text (`nc`) and its cycles (`kernel`): code and data, no sentences. */
interface Data {
  /** The block is understood but not simulated. */
  notSimulated: { what: string };
  /** It can change the path or the stock: unverified from here on. */
  notProved: { what: string };
  cycleNotSimulated: { cycle: number; name: string };
  /** A cycle call without a definition before it. */
  noCycleDefined: {};
  noToolCalled: {};
  toolUnknown: { tool: string };
  notInTurnMode: {};
  /** RL or RR is active where the control requires R0: at a cycle call, or in PS before an APPR. */
  compensationActive: { side: "RL" | "RR" };
  /** A cutting feed of 0, as it is written, or FAUTO without a feed in TOOL CALL. */
  feedZero: { word: string };
  /** A valid feed that is surely a typing error. */
  feedUnlikely: { feed: number; unit: FeedUnit };
  /** Bore deeper than the cutting edge length of the drill. */
  drillTooShort: { depth: number; edges: number };
  /** A centre drill whose mouth at the face is not that of its hole. */
  centreMouth: { mouth: number; wanted: number; depth: number };
  /** Point of the drill longer than the bore is deep: the bore nowhere has its diameter. */
  pointBeyondDepth: { point: number; depth: number };
  /** Pitch of the cycle differs from that of the tap. */
  pitchOfTap: { pitch: number; tap: number };
  cycleNeverCalled: { cycle: number };
  /** Motion or a call behind the program end. */
  neverReached: { by: string };
  /** A parameter that the cycle lacks, or a duplicate. */
  parameterForeign: { name: string; cycle: number };
  /** The cycle list is one of older software; `filled` are the values that the control adds, as words of the list. */
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
  /** Constant surface speed without SMAX near the axis: smallest diameter in mm, and its block. */
  speedUnlimited: { diameter: number; block: number };
  /** Above the limit of the material, m/min, or of the machine, rpm. */
  speedUnlikely: { speed: number; most: number; of: "material" | "machine" };
  /** Turning off centre by this many mm in Y. */
  offCentre: { y: number };
  /** TOOL CALL with an index missing in the table; `rows` are the existing rows of the tool. */
  toolIndexUnknown: { tool: string; rows: readonly string[] };
  /** The first block of a contour counts from a previous point. */
  firstElement: { word: string };
  /** A printed rule of the control; `word` is what breaks it. */
  controlRule: { rule: ControlRule; word: string };
  parameterUnset: { name: string };
  divisionByZero: {};
  notFinite: { text: string };
  /** `; CLAMPING …`: words not understood (the rest counts), required words missing, or a second clamping. */
  clampingUnread: { what: string };
  clampingIncomplete: { words: string };
  clampingTwice: {};
  /** Jaws or collet grip a ⌀ without blank, or inside the blank. */
  clampingMisses: { diameter: number };
  blankMissing: {};
  blankNotTurned: { form: string };
  blankImpossible: {};
  /**
   * A rotating box: its stock is the cylinder around its corners, with material all round only within the inner
   * diameter.
   */
  boxTurned: { outer: number; inner: number };
  /** The outline of FUNCTION TURNDATA BLANK is the stock, as BLK FORM gives no body of revolution. */
  blankTaken: { what: string };
  /** That outline has more material than BLK FORM, mm². */
  blankAdds: { what: string; area: number };
  /** Roughing skips passes that miss the traced blank; other cuts in the air are run. */
  blankTraced: {};
  poleMissing: {};
  startUnknown: {};
  /** A blank dimension set by the user that contradicts the contour: ⌀ or Z, mm. */
  blankAgainstContour: {
    place: "outside" | "bore" | "length" | "allowance" | "thread";
    contour: number;
    blank: number;
    other?: string;
    nearest: number;
  };
  /** An element of a free contour with several solutions, or with contradicting values. */
  freeChosen: {};
  freeUnsolved: { form: string };
  arcImpossible: {};
  radiusCompensation: { side: "RL" | "RR" };
  /** RL or RR with a tip orientation that names no side: the direction of the compensation is undefined. */
  compensationUndefined: { side: "RL" | "RR"; orientation: number };
  /** RL to RR or back without R0 between. */
  sideChanged: {};
  /** APPR without an element behind it, DEP without one before it. */
  approachWithoutContour: { form: string };
  /** DZL and DXL of the table: the control includes them, so the tip stays on the path. */
  lengthDelta: { tool: number };
  /** The path is that of a tool of radius 0. */
  toolRadiusUnknown: { tool: string };
  /** The words of this block are recalled, not verified on a printed page. */
  wordsRecalled: { what: string };
  programEndMissing: {};
  tooManyBlocks: { limit: number };
  tooManyRepeated: { limit: number };
  tooManyMoves: { limit: number };
  contourTooLong: { limit: number };
  tooManyOperations: { limit: number };
  /** Number of findings of one code that are not listed from here on. */
  moreAlike: { code: string; count: number };
  callsTooDeep: { limit: number };
  programsTooDeep: { limit: number };
  /** M2 or M30 in a program that is called. */
  endInCalled: { word: string };
  /** A called program that was not opened. */
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
