import type { ClampPart } from "../area/clamping.ts";

/**
 * What can be wrong with values, tools and paths: a code with its data, never a sentence. Languages make the sentences
 * (`i18n`), so a new code is a compile error in every language until it has its text. All lengths mm; diameters say so.
 */
export type Severity = "error" | "warning" | "info";

/** Why material stays. */
export type Reason =
  | "insertRadius"
  | "mainEdge"
  | "secondaryEdge"
  | "toolWidth"
  | "cutLength"
  | "limit"
  | "plunging"
  | "oversize"
  | "smoothing"
  | "correction"
  | "overCrest";

/**
 * The data of each code. `nearest` is the nearest value that works, in the units of the field at `at`: tried, or left
 * out. It never is another dimension of the drawing; where the sign of one is impossible, it is the other sign.
 */
interface Data {
  /* single values */
  missing: {};
  notANumber: { text: string };
  badExpression: { text: string };
  unknownParameter: { name: string };
  outOfRange: { value: number; min: number; max: number; nearest?: number };
  notWhole: { value: number; nearest?: number };
  notAChoice: { value: number; choices: readonly number[]; nearest?: number };
  /* values against each other */
  startEqualsEnd: { other: string; value: number };
  /** A simple cycle starts where the tool stands: level with its end there is nothing between the two. */
  startLevelWithEnd: { axis: "X" | "Z"; value: number };
  /** A diameter in the range of the control that no contour of this cycle can have: the far side of the axis. */
  diameterNegative: { value: number; nearest?: number };
  /** The end of a contour in front of its start, where there is no material: a minus that was forgotten. */
  endInFront: { value: number; nearest: number };
  /**
   * Start and end of a contour, ⌀ or Z, in an order in which there is no material for it, and in the other order there
   * is.
   */
  endsExchanged: { axis: "X" | "Z"; start: number; end: number; other: string };
  elementTooLong: { size: number; max: number };
  cornersTooWide: { radius: number; max: number };
  wallsMeet: { angle: number; max: number };
  /* values against the tool */
  cornerSmallerThanInsert: { radius: number; insert: number };
  recessNarrowerThanTool: { width: number; tool: number; nearest?: number };
  angleNotFollowed: { angle: number; max: number; edge: "mainEdge" | "secondaryEdge" | "toolWidth"; element?: number };
  tooManyPasses: { passes: number; most: number; nearest?: number };
  infeedOverCutLength: { infeed: number; cutLength: number; nearest?: number };
  depthOverCutLength: { depth: number; cutLength: number };
  offsetReduced: { offset: number; kept: number; nearest?: number; passes: number };
  offsetOverLimit: { offset: number; max: number; passes: number; nearest?: number };
  /** By its TYPE or its tip orientation; those that can. */
  toolUnfit: { type: string; orientation: number; types: readonly string[]; orientations: readonly number[] };
  toolCannotCutSideways: { type: string };
  flanksNotChecked: {};
  toolColumn: { column: string; value: number | null; max?: number; min?: number; nearest?: number };
  toolNumberTwice: { number: number; nearest?: number };
  toolName: { text: string; max: number };
  /** A holder: the axis of its shank, the corners of its head. */
  holderAxis: { text: string };
  holderHead: { text: string };
  betterTool: { tool: number; name: string };
  /* threads */
  pitchZero: {};
  /** The depth that counts because none was entered: a part of the pitch. */
  depthFromPitch: { depth: number; pitch: number; factor: number };
  /**
   * The same with an insert of another profile than the metric one, to which the factor belongs. `right`: what its own
   * profile has, in pitches and on the radius.
   */
  depthOfOtherProfile: {
    depth: number;
    pitch: number;
    factor: number;
    angle: number;
    right?: number;
    nearest?: number;
  };
  /** CUTLENGTH is empty: the tooth of the insert is taken to be this high, mm. */
  toothAssumed: { height: number };
  /** The insert is too low for the depth. */
  threadOverInsert: { depth: number; most: number };
  /**
   * Material stands over the crest, or over its line in the run-in or the overrun; `most` is how high it may, where
   * that is too high.
   */
  threadMeets: { place: "over" | "before" | "behind"; over: number; x: number; z: number; most?: number };
  /** Steeper than the flank of the insert, so that passes would cut into the finished flank. */
  flankInfeedTooSteep: { angle: number; most: number; nearest?: number };
  runOutTooLong: { size: number; max: number; nearest?: number };
  /** The thread does not run on along the axis that is locked to the spindle. */
  threadTurnsBack: { axis: "X" | "Z" };
  /**
   * Where the run-in begins, the tool would stand in material; without an offer where no run-in of a usual length leads
   * past it.
   */
  runInBlocked: { x: number; z: number; nearest?: number };
  /** Turns of the spindle in all passes together. */
  threadTooMany: { turns: number; most: number };
  /** A cone whose angle does not lead from one diameter to the other. */
  taperImpossible: { angle: number };
  /** mm/min, and the speed up to which it is not more. */
  threadFeedOverLimit: { feed: number; most: number; speed: number; upTo: number };
  /**
   * The spindle runs at a constant surface speed, m/min; rpm at the largest diameter of the passes and at the smallest.
   */
  threadSurfaceSpeed: { cuttingSpeed: number; slow?: number; fast?: number };
  runInShort: { runIn: number; needed: number; speed: number; nearest?: number };
  /* start point and limits */
  startInArea: { x: number; z: number };
  /**
   * The start point lies behind the contour start, mm along the axis: the tool goes to the clearance in front of it.
   */
  startBehindContour: { behind: number; clearance: number };
  startInMaterial: { x: number; z: number };
  /** mm across the cutting direction. */
  startBelowContour: { below: number };
  /** The tool would stand in the finished part; at x and z it would not. */
  startInPart: { x: number; z: number };
  /**
   * The insert reaches across the axis into the part; `nearest` is a diameter of the start point at which it does not.
   */
  insertAcrossAxis: { reach: number; nearest?: number };
  /**
   * There is no bore to cut in: solid from `z` on, though the path goes on to `to`. `need`: the smallest bore that the
   * tool fits in at the start point, as a diameter.
   */
  boreMissing: { z: number; to: number; need: number };
  /** The contour is run towards the start point; from the other side, at x and z, it works. */
  startOnWrongSide: { x: number; z: number };
  startInsideEnvelope: { clearance: number };
  limitOnWrongSide: { limit: number; nearest?: number };
  /**
   * What an operation takes on the side of its machining limit that is not to be cut, mm². `finishing`: its roughing,
   * which ran as well, takes nothing there.
   */
  cutBehindLimit: { area: number; x: number; z: number; finishing: boolean };
  nothingToCut: {};
  /* contour subprogram; `element` counts from 1 */
  contourMissing: { label: string };
  contourTooShort: {};
  /** It starts and ends on one diameter (X) or in one plane (Z). */
  contourFlat: { axis: "X" | "Z" };
  /** From its end the part cannot go on: an element of the contour is in the way. */
  contourEndCovered: { x: number; z: number };
  contourPoint: { element: number };
  cornerElementAlone: { element: number };
  cornerElementTooLong: { element: number; size: number; max: number };
  arcOffCircle: { element: number; gap: number };
  arcTooSmall: { element: number; radius: number };
  /** Values still missing before an element is determined. */
  elementFree: { element: number; freedom: number };
  /** Something given does not agree with the rest; `nearest` does. Degrees for angles, mm otherwise. */
  elementContradicts: {
    element: number;
    quantity: "angle" | "length" | "tangent" | "radius";
    given: number;
    nearest: number;
  };
  elementUnreachable: { element: number };
  /** An arc by its centre without a centre before it. */
  centreMissing: { element: number };
  contourCrossesItself: { element: number; other: number };
  /** An undercut needs a cylinder and a face that meet; a recess a straight element of its direction. */
  undercutNeighbours: { element: number };
  /** A word of an undercut or recess that is missing, or whose value makes no shape. */
  recessWord: { element: number; word: string };
  /** Two words of a recess that say the same thing in two ways: it takes one of them. */
  recessWordsExclusive: { element: number; word: string; other: string };
  /**
   * A thread relief by a pitch that DIN 76 does not list, mm, with its neighbours there; `words` are those that the
   * block has to have.
   */
  pitchNotListed: { element: number; pitch: number; below?: number; above?: number; words: string };
  /** Words that the standard gave because the block has none. */
  undercutDefaults: { element: number; words: string };
  /* working plane: compensation, approach and departure. Of a place, milling has x and y; turning x (⌀) and z */
  /** In milling with the middle of the element. */
  toolRadiusTooLarge: { element: number; radius: number; nearest?: number; x?: number; y?: number };
  /** Milling one element cuts another that is not its neighbour. */
  pathCutsContour: { element: number; other: number; depth: number; x: number; y: number; nearest?: number };
  approachNeedsSide: {};
  approachSideAssumed: {};
  approachInsideCircle: { point: "PS" | "PN"; radius: number; nearest?: number };
  /** On the way from PS or to PN; a point from where the way is free. */
  approachCutsContour: {
    point: "PS" | "PN";
    depth: number;
    x: number;
    y?: number;
    z?: number;
    freeX: number;
    freeY?: number;
    freeZ?: number;
  };
  /** The same where another LEN or R helps. */
  approachValueCutsContour: {
    point: "PS" | "PN";
    depth: number;
    x: number;
    y?: number;
    z?: number;
    word: "LEN" | "R";
    nearest: number;
  };
  /** The same where nothing simple helps. */
  approachBlocked: { point: "PS" | "PN"; depth: number; x: number; y?: number; z?: number };
  /* proof */
  /** `asked`: the values ask for it: an oversize, or a corner to which no radius is given. */
  materialLeft: { reason: Reason; area: number; x: number; z: number; asked?: true };
  gouge: { area: number; x: number; z: number };
  /**
   * Behind its end a thread cuts the finished part: its tip at the depth (`shaft`), or a flank what stands beside the
   * way of the tip (`shoulder`). `to`: how far the tip goes, along Z or, in a face, as a diameter; so does `end`, where
   * the thread ends.
   */
  threadOverruns: {
    meets: "shaft" | "shoulder";
    area: number;
    x: number;
    z: number;
    axis: "X" | "Z";
    end: number;
    to: number;
  };
  /**
   * Over more than half of a thread there is less material than its crest needs: `missing` mm of it, on the radius or
   * along Z, and what would be right, as a diameter or, in a face, as a Z.
   */
  crestMissing: { missing: number; diameter: number } | { missing: number; z: number };
  rapidInStock: { area: number; x: number; z: number };
  holderContact: { x: number; z: number };
  /** A plain cut goes below the contour of the cycle that is called in `block`, mm². */
  cutBelowContour: { block: number; area: number; x: number; z: number };
  /** A piece no longer hangs together with the clamped end, mm²: `block` has cut it loose. */
  cameLoose: { shape: "piece" | "ring" | "slug"; area: number; block: number; x: number; z: number };
  /** The same where a blade or a plain cut parts it off. */
  partedOff: { area: number; block: number; x: number; z: number };
  /** A cut on a piece that `block` has cut loose, mm². */
  cutOnLoosePiece: { area: number; block: number; x: number; z: number };
  /**
   * Behind the rear end of the blank, at `rear`, below its diameter; "unheld": its outside is turned away up to there.
   */
  behindBlank: { motion: "rapid" | "feed" | "unheld"; x: number; z: number; rear: number };
  /** Tool or holder meets what the work is held by, as it is stated. */
  clampContact: { part: ClampPart; by: "tool" | "holder"; x: number; z: number };
  /** A cut without a spindle that turns as it must; `block` stopped it or set its direction, absent where none has. */
  spindleStopped: { how: "stopped" | "noSpeed" | "hand"; block?: number };
  /** A tap, reamer or boring tool feeds where there is no hole of this diameter, mm. */
  holeMissing: { tool: number; diameter: number; z: number };
  /** So many moves do damage that those behind them were not looked at. */
  contactsUnlooked: { limit: number };
  /** A cut takes more stock at once than the infeed allows, mm; `pass` is absent on a smoothing or finishing cut. */
  deeperThanInfeed: { depth: number; allowed: number; pass?: number };
  /** The operation removed no stock. */
  nothingCut: {};
  /** The outline of a blank that is stated has less than what stands there: how much, mm². */
  blankLacks: { what: string; area: number };
  /** It has more than what stands there after the cuts so far. */
  blankGone: { what: string; area: number };
  /** Roughing passes that touched no stock. */
  airPasses: { count: number };
}

export type Code = keyof Data;
/** One finding. `at` names the field: a Q number, a tool column, "tool", "start.x", "start.z", "contour". */
export type Issue = {
  [C in Code]: {
    readonly code: C;
    readonly severity: Severity;
    readonly at?: string;
    readonly data: Readonly<Data[C]>;
  };
}[Code];

/** Makes one issue; the compiler checks that the data fit the code. */
export function issue<C extends Code>(code: C, severity: Severity, data: Data[C], at?: string): Issue {
  return (at === undefined ? { code, severity, data } : { code, severity, at, data }) as Issue;
}
