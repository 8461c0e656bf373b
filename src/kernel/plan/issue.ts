import type { ClampPart } from "../area/clamping.ts";

/**
 * Issues of values, tools and paths: a code with its data, never a sentence. The languages (`i18n`) make the sentences,
 * so a new code is a compile error in every language until it has its text. All lengths mm; diameters say so.
 */
export type Severity = "error" | "warning" | "info";

/** A stated limit of a tool, by its column. */
export type ToolLimit = "DAXN" | "DAXX" | "CDX" | "CUTDIA" | "DMIN";

/** Cause of residual material. */
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
  | "overCrest"
  | "behindContour";

/**
 * The data of each code. `nearest` is the nearest value that works, in the units of the field at `at`; it has been
 * tried, or is left out. It is never another dimension of the drawing; where the sign is impossible, it is the value
 * with the other sign.
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
  /* values that contradict each other */
  startEqualsEnd: { other: string; value: number };
  /** A simple cycle starts at the tool position: if its end is level with it, there is nothing in between to cut. */
  startLevelWithEnd: { axis: "X" | "Z"; value: number };
  /**
   * A diameter in the input range of the control but on the far side of the axis, where no contour of this cycle can
   * be.
   */
  diameterNegative: { value: number; nearest?: number };
  /** The end of a contour in front of its start, where there is no material: the minus sign is missing. */
  endInFront: { value: number; nearest: number };
  /** The start of a contour far in front of the blank, its end inside it: the minus sign is missing. */
  startInFront: { value: number; nearest: number };
  /** A diameter of the drawing larger than that of the blank: with it, the cycle turns a bore, or cuts the air. */
  diameterOutside: { value: number; blank: number };
  /** The contour begins inside a blank without a bore. */
  diameterInSolid: { value: number };
  /**
   * Start and end of a contour, ⌀ or Z, are exchanged: in this order there is no material between them, in the other
   * there is.
   */
  endsExchanged: { axis: "X" | "Z"; start: number; end: number; other: string };
  elementTooLong: { size: number; max: number };
  cornersTooWide: { radius: number; max: number };
  wallsMeet: { angle: number; max: number };
  /* values that do not fit the tool */
  cornerSmallerThanInsert: { radius: number; insert: number };
  recessNarrowerThanTool: { width: number; tool: number; nearest?: number };
  /** `max` is the limit of the tool; behind the contour no tool has a larger one. */
  angleNotFollowed: {
    angle: number;
    max: number;
    edge: "mainEdge" | "secondaryEdge" | "toolWidth" | "behindContour";
    element?: number;
  };
  tooManyPasses: { passes: number; most: number; nearest?: number };
  infeedOverCutLength: { infeed: number; cutLength: number; nearest?: number };
  depthOverCutLength: { depth: number; cutLength: number };
  offsetReduced: { offset: number; kept: number; nearest?: number; passes: number };
  offsetOverLimit: { offset: number; max: number; passes: number; nearest?: number };
  /** Unfit by its TYPE or its tip orientation; `types` and `orientations` list those that fit. */
  toolUnfit: { type: string; orientation: number; types: readonly string[]; orientations: readonly number[] };
  toolCannotCutSideways: { type: string };
  flanksNotChecked: {};
  toolColumn: { column: string; value: number | null; max?: number; min?: number; nearest?: number };
  toolNumberTwice: { number: number; nearest?: number };
  toolName: { text: string; max: number };
  /** A holder: the axis of its shank, the corners of its head. */
  holderAxis: { text: string };
  holderHead: { text: string };
  /** The support of a blade is none of the known words. */
  bladeSupport: { text: string };
  /** A straight blade that plunges along Z. */
  straightBlade: {};
  /** Stated length of a drill's point, and the length that its radius and angle make, mm. */
  pointDiffers: { length: number; byAngle: number; angle: number };
  betterTool: { tool: number; name: string };
  /* threads */
  pitchZero: {};
  /** The depth assumed because none was entered: a share of the pitch. */
  depthFromPitch: { depth: number; pitch: number; factor: number };
  /**
   * The same for an insert with a profile other than metric, for which the factor is wrong. `right`: depth of its own
   * profile, in pitches and on the radius.
   */
  depthOfOtherProfile: {
    depth: number;
    pitch: number;
    factor: number;
    angle: number;
    right?: number;
    nearest?: number;
  };
  /** CUTLENGTH is empty: the assumed height of the insert's tooth, mm. */
  toothAssumed: { height: number };
  /** The insert is too low for the depth. */
  threadOverInsert: { depth: number; most: number };
  threadTooSteep: { angle: number; most: number };
  /**
   * Material above the crest, or above its line in the run-in or the overrun; `most` is the permitted height, where it
   * is exceeded.
   */
  threadMeets: { place: "over" | "before" | "behind"; over: number; x: number; z: number; most?: number };
  /** The infeed is steeper than the flank of the insert, so that passes would cut into the finished flank. */
  flankInfeedTooSteep: { angle: number; most: number; nearest?: number };
  runOutTooLong: { size: number; max: number; nearest?: number };
  /** The thread does not advance steadily along the axis that is locked to the spindle. */
  threadTurnsBack: { axis: "X" | "Z" };
  /**
   * At the start of the run-in, the tool would be in material; no offer where no run-in of a common length avoids it.
   */
  runInBlocked: { x: number; z: number; nearest?: number };
  /** Spindle revolutions of all passes together. */
  threadTooMany: { turns: number; most: number };
  /** A cone whose angle does not lead from one diameter to the other. */
  taperImpossible: { angle: number };
  /** mm/min; `upTo` is the speed up to which the limit is kept. */
  threadFeedOverLimit: { feed: number; most: number; speed: number; upTo: number };
  /**
   * The spindle runs at a constant surface speed, m/min; rpm at the largest diameter of the passes and at the smallest.
   */
  threadSurfaceSpeed: { cuttingSpeed: number; slow?: number; fast?: number };
  runInShort: { runIn: number; needed: number; speed: number; nearest?: number };
  /* start point and limits */
  startInArea: { x: number; z: number };
  /** The start point is behind the contour start, mm along the axis: the tool moves to the clearance in front of it. */
  startBehindContour: { behind: number; clearance: number };
  startInMaterial: { x: number; z: number };
  /** mm across the cutting direction. */
  startBelowContour: { below: number };
  /** The tool would be inside the finished part; at x and z it is clear. */
  startInPart: { x: number; z: number };
  /** The insert reaches across the axis into the part; `nearest` is a start diameter at which it does not. */
  insertAcrossAxis: { reach: number; nearest?: number };
  /**
   * There is no bore to cut in: solid from `z` on, although the path continues to `to`. `need`: the smallest bore that
   * the tool fits in at the start point, as a diameter.
   */
  boreMissing: { z: number; to: number; need: number };
  /** The contour runs towards the start point; from the other side, at x and z, it works. */
  startOnWrongSide: { x: number; z: number };
  startInsideEnvelope: { clearance: number };
  limitOnWrongSide: { limit: number; nearest?: number };
  /**
   * Area an operation cuts on the wrong side of its machining limit, mm². `finishing`: only the finishing does; its
   * roughing, which ran as well, does not.
   */
  cutBehindLimit: { area: number; x: number; z: number; finishing: boolean };
  nothingToCut: {};
  /* contour subprogram; `element` counts from 1 */
  contourMissing: { label: string };
  contourTooShort: {};
  /** The contour starts and ends on one diameter (X) or in one plane (Z). */
  contourFlat: { axis: "X" | "Z" };
  /** The part cannot continue from the end of the contour: an element of the contour is in the way. */
  contourEndCovered: { x: number; z: number };
  contourPoint: { element: number };
  cornerElementAlone: { element: number };
  cornerElementTooLong: { element: number; size: number; max: number };
  arcOffCircle: { element: number; gap: number };
  arcTooSmall: { element: number; radius: number };
  /** `freedom`: number of values still missing to determine the element. */
  elementFree: { element: number; freedom: number };
  /** A given value contradicts the others; `nearest` fits. Degrees for angles, mm otherwise. */
  elementContradicts: {
    element: number;
    quantity: "angle" | "length" | "tangent" | "radius";
    given: number;
    nearest: number;
  };
  elementUnreachable: { element: number };
  /** An arc about a centre that no block before it defines. */
  centreMissing: { element: number };
  contourCrossesItself: { element: number; other: number };
  /** An undercut needs a cylinder and a face that meet; a recess a straight element of its direction. */
  undercutNeighbours: { element: number };
  /** A word of an undercut or recess that is missing, or whose value makes no shape. */
  recessWord: { element: number; word: string };
  /** Two words of a recess for the same dimension: only one is allowed. */
  recessWordsExclusive: { element: number; word: string; other: string };
  /**
   * A thread relief with a pitch that DIN 76 does not list, mm, with its neighbours there; `words` are the words that
   * the block then needs.
   */
  pitchNotListed: { element: number; pitch: number; below?: number; above?: number; words: string };
  /** Words taken from the standard because the block has none. */
  undercutDefaults: { element: number; words: string };
  /* working plane: compensation, approach and departure. Places have x and y in milling, x (⌀) and z in turning */
  /** In milling with the midpoint of the element. */
  toolRadiusTooLarge: { element: number; radius: number; nearest?: number; x?: number; y?: number };
  /** Milling one element cuts another that is not its neighbour. */
  pathCutsContour: { element: number; other: number; depth: number; x: number; y: number; nearest?: number };
  approachNeedsSide: {};
  approachSideAssumed: {};
  approachInsideCircle: { point: "PS" | "PN"; radius: number; nearest?: number };
  /** On the path from PS or to PN; with a point from which the path is free. */
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
  /** The same where a different LEN or R helps. */
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
  /* check */
  /** `asked`: the values ask for it, by an oversize or by a corner without a radius. */
  materialLeft: { reason: Reason; area: number; x: number; z: number; asked?: true };
  gouge: { area: number; x: number; z: number };
  /**
   * Behind its end a thread cuts the finished part: with its tip at the depth (`shaft`), or with a flank beside the
   * path of the tip (`shoulder`). `to`: end of the tip's travel, along Z or, in a face, as a diameter; `end`: end of
   * the thread.
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
   * Along more than half of a thread there is too little material for its crest: `missing` mm, on the radius or along
   * Z, and the right size, as a diameter or, in a face, as a Z.
   */
  crestMissing: { missing: number; diameter: number } | { missing: number; z: number };
  rapidInStock: { area: number; x: number; z: number };
  holderContact: { x: number; z: number };
  /** A cut outside cycles goes below the contour of the cycle called in `block`, mm². */
  cutBelowContour: { block: number; area: number; x: number; z: number };
  /** The same, marked as intended, in the blocks that cut, mm². */
  intendedCut: { blocks: readonly number[]; area: number; x: number; z: number };
  /** A piece is no longer connected to the clamped end, mm²: `block` has cut it loose. */
  cameLoose: { shape: "piece" | "ring" | "slug"; area: number; block: number; x: number; z: number };
  /** The same where a parting blade or a cut outside cycles parts it off. */
  partedOff: { area: number; block: number; x: number; z: number };
  /** A cut on a piece that `block` has cut loose, mm². */
  cutOnLoosePiece: { area: number; block: number; x: number; z: number };
  /**
   * A motion behind the rear end of the blank, at `rear`, below its diameter; "unheld": its outside is turned away up
   * to there.
   */
  behindBlank: { motion: "rapid" | "feed" | "unheld"; x: number; z: number; rear: number };
  /** Tool or holder collides with the stated clamping. */
  clampContact: { part: ClampPart; by: "tool" | "holder"; x: number; z: number };
  /**
   * A cut while the spindle does not turn as required; `block` stopped it or set its direction, absent where none has.
   */
  spindleStopped: { how: "stopped" | "noSpeed" | "hand"; block?: number };
  /** A tap, reamer or boring tool feeds where there is no hole of this diameter, mm. */
  holeMissing: { tool: number; diameter: number; z: number };
  /** The tool works beyond a limit that its row states: a diameter, or a depth for CDX, mm. */
  toolLimit: { tool: number; column: ToolLimit; value: number; limit: number; x: number; z: number };
  /** More moves than `limit` do damage; the moves behind them were not checked. */
  contactsUnlooked: { limit: number };
  /** A cut is deeper than the infeed allows, mm; `pass` is absent on a smoothing or finishing cut. */
  deeperThanInfeed: { depth: number; allowed: number; pass?: number };
  /** The operation removed no stock. */
  nothingCut: {};
  /** The stated outline of a blank is smaller than the stock: missing area, mm². */
  blankLacks: { what: string; area: number };
  /** The stated outline is larger than the stock after the cuts so far, mm². */
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
