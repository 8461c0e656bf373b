/** What a program of this folder must report. Codes carry their severity from `SEVERITY`. */
export interface Expected {
  /** In words, for the name of the test. */
  readonly says: string;
  /** Codes that must be reported; with a number, exactly that many of them. */
  readonly has?: Readonly<Record<string, number | true>>;
  readonly hasNot?: readonly string[];
  /** Codes of errors allowed at all; everything else must be no error. */
  readonly errors?: readonly string[];
  /** At most this many errors. */
  readonly mostErrors?: number;
  /** An error that names one of these fields. */
  readonly errorAt?: readonly string[];
  readonly verdict?: "proved" | "faults" | "incomplete";
  /** Whether the proof finds any, mm². */
  readonly gouge?: boolean;
  readonly rapidInStock?: boolean;
  /** Most material that stays, mm². */
  readonly left?: number;
  /** Reasons of what stays: one that must be there, and those that must not hold more than the area given. */
  readonly reason?: string;
  readonly noReason?: Readonly<Record<string, number>>;
  readonly unproved?: boolean;
  /** Ends of the motion outside cycles, in order: [X, Z]. What the first position is reached from is not known, so it is no move. */
  readonly path?: readonly (readonly [x: number, z: number])[];
  /** Feeds of the motion outside cycles by block. */
  readonly feeds?: Readonly<Record<number, number>>;
  /** Diameter of the deepest long roughing cut along Z. */
  readonly lastLevel?: number;
  /** Lowest Z that the first operation cuts to. */
  readonly lowestZ?: number;
  /** No finishing cut runs along this Z, or passes it by more than the clearance given. */
  readonly finishAlongZ?: { readonly z: number; readonly beyond?: { readonly side: 1 | -1; readonly most: number } };
  /** Circular motion of a block in the X/Z plane: centre [X, Z]. */
  readonly arcInXZ?: Readonly<Record<number, readonly [x: number, z: number]>>;
  /** Every operation runs the same moves from its own start point, and comes back to it at rapid. */
  readonly alike?: true;
  /** Motion follows the blocks in order. */
  readonly inOrder?: true;
  /** Nothing stays on the axis. */
  readonly cleanAtAxis?: true;
  /** No motion of an operation comes nearer to the axis than this X. */
  readonly notNearer?: number;
  /** No finding offers a value below 0. */
  readonly offersNoNegative?: true;
  /** Not yet so. */
  readonly pending?: true;
}

/** Severities that scripts rely on. */
export const SEVERITY: Readonly<Record<string, "error" | "warning" | "info">> = {
  notInTurnMode: "error",
  compensationActive: "error",
  toolUnfit: "error",
  labelTwice: "error",
  feedZero: "error",
  feedUnlikely: "warning",
  cycleNeverCalled: "warning",
  neverReached: "warning",
  deeperThanInfeed: "warning",
  nothingCut: "warning",
  airPasses: "info",
  notProved: "warning",
  startUnknown: "warning",
  parameterForeign: "warning",
  tooManyPasses: "error",
  rapidInStock: "error",
  gouge: "error",
  holderContact: "error",
  clampContact: "error",
  materialLeft: "warning",
  threadOverruns: "error",
  crestMissing: "warning",
  threadSurfaceSpeed: "warning",
  runInBlocked: "error",
  pitchNotListed: "error",
  holeMissing: "error",
  boreMissing: "error",
};

const clean = { gouge: false, rapidInStock: false } as const;

export const expected: Readonly<Record<string, Expected>> = {
  "clamped-bar": {
    says: "turned to its very end, a bar in stated jaws is met by tool and holder",
    has: { clampContact: 2 },
    hasNot: ["rapidInStock", "gouge", "holderContact"],
    verdict: "faults",
    ...clean,
  },
  "p03-812-cyl-chamfer-506-2": { says: "the last level lies on the cylinder, whatever the chamfer", lastLevel: 50.4, ...clean },
  "p06-exactk": {
    says: "steps of Q506 = 2 stay for want of smoothing, not as oversize",
    reason: "smoothing",
    noReason: { oversize: 0.05 },
    ...clean,
  },
  "h02-852-509p": { says: "Q509 above 0: one shifted contour, no gouge", gouge: false, hasNot: ["gouge"] },
  "h13-852-509m-r": { says: "Q509 below 0: one shifted contour, neither gouge nor residue", ...clean, left: 0.05 },
  "z03-820-pin-turn-fin-Z0": {
    says: "Q499 = 1 from the wrong side is an error at the start point, and cuts nothing",
    gouge: false,
    errorAt: ["start.x", "start.z"],
  },
  "x11-820-pin-out-fin": { says: "the finishing lead-in leaves the corner", gouge: false, hasNot: ["gouge"] },
  "f08-820-limit-belowside-fin": {
    says: "finishing stops at the limit and leaves",
    gouge: false,
    finishAlongZ: { z: -10, beyond: { side: 1, most: 2.1 } },
  },
  "f01-820-limit-Z": {
    says: "finishing does not run along the limit",
    ...clean,
    finishAlongZ: { z: -10, beyond: { side: -1, most: 0.01 } },
  },
  "f02-820-limit-X40": {
    says: "what stays behind the limit stays for the limit",
    ...clean,
    reason: "limit",
    noReason: { insertRadius: 1 },
  },
  "w01-neg-collision": {
    says: "a rapid through the bar on the other side of the axis is a rapid in stock",
    rapidInStock: true,
    has: { rapidInStock: true },
    verdict: "faults",
  },
  "s13-datum": { says: "the datum shift is run", lowestZ: -85.734, unproved: false },
  datum: { says: "both datum shifts are run", path: [[70, 3], [70, -19], [85, -19]], unproved: false },
  m91_between: {
    says: "M91 goes to a place that is not of the workpiece: nothing false",
    ...clean,
    hasNot: ["gouge", "rapidInStock"],
    mostErrors: 0,
  },
  bore_m140: { says: "M140 MB MAX draws back: nothing false", ...clean, hasNot: ["gouge", "rapidInStock"], mostErrors: 0 },
  jump: {
    says: "the jumps are run",
    hasNot: ["gouge", "notProved"],
    unproved: false,
    path: [78, 74, 70, 66, 62].flatMap((x): [number, number][] => [[x, -40], [x + 2, -39], [x + 2, 2], x > 62 ? [x - 4, 2] : [100, 50]]),
  },
  arcs_xz: { says: "an arc in XZ runs in its plane", arcInXZ: { 5: [10, 5] } },
  feedm140: { says: "the F behind M140 and M128 belongs to them", feeds: { 3: 125, 4: 125, 6: 125, 8: 125 } },
  paraxial: {
    says: "a block without L is a straight one",
    path: [[70, 5], [70, -20], [82, -20], [82, 5], [60, 5]],
    hasNot: ["notUnderstood"],
  },
  "blade-reaches": {
    says: "CUTLENGTH counts in the material, not from the start point",
    ...clean,
    left: 0.05,
    hasNot: ["depthOverCutLength", "materialLeft"],
  },
  "equal-grooves": { says: "equal grooves run the same path, whatever stood there", ...clean, left: 0, alike: true },
  "as-wide-as-the-blade": {
    says: "a groove as wide as the blade is cut to its floor",
    ...clean,
    left: 0,
    hasNot: ["deeperThanInfeed", "materialLeft"],
  },
  "hardly-wider-than-the-blade": {
    says: "a pass without a way plunges no deeper than Q463",
    ...clean,
    left: 0,
    hasNot: ["deeperThanInfeed"],
  },
  "oversize-too-wide": { says: "an oversize that leaves no room for the blade is told at the oversize", errorAt: ["Q484"], mostErrors: 1 },
  tiny: { says: "an arc that ends under a micron from the next point makes no move of its own", inOrder: true },
  "j02-nomode": { says: "a cycle without FUNCTION MODE TURN", has: { notInTurnMode: true } },
  "s06-812-RL-active-call": { says: "RR is active at the call", has: { compensationActive: true } },
  "k12-PS-RL": { says: "RL is active at PS", has: { compensationActive: true } },
  "j09-820-lbltwice": { says: "a label set twice", has: { labelTwice: true } },
  "j13-812-nocall": { says: "a cycle that is never called", has: { cycleNeverCalled: true }, verdict: "incomplete" },
  "i34-unknownQ": { says: "Q parameters that the cycle does not have", has: { parameterForeign: 2 } },
  "r18-812-firstpass-deep": { says: "the first pass is deeper than Q463", has: { deeperThanInfeed: true } },
  "t08-812-tool": { says: "an axial blade cannot turn a shoulder", has: { toolUnfit: true } },
  "r12-852-T9-radial-tool": { says: "a radial tool cannot cut a face", has: { toolUnfit: true } },
  "i08-Q478-FAUTO-noF": { says: "FAUTO without a feed", has: { feedZero: true } },
  "o02-820-face-X0": { says: "a face to X0 leaves nothing", ...clean, left: 0, hasNot: ["materialLeft"] },
  "b07-812-S-Z-farbehind": { says: "a start point in the air does not stand in the material", hasNot: ["startInMaterial"] },
  "i23-Q491neg": { says: "one range everywhere", hasNot: ["outOfRange"] },
  "brought-into-stock": {
    says: "the first rapid of a tool ends in material: it has run into it, wherever it came from",
    rapidInStock: true,
    has: { rapidInStock: 1 },
    verdict: "faults",
  },
  "brought-last": {
    says: "a tool that is brought into material and moves no more has run into it all the same",
    rapidInStock: true,
    has: { rapidInStock: 1 },
    verdict: "faults",
  },
  "brought-changed": {
    says: "so has one that is changed where it was brought to",
    rapidInStock: true,
    has: { rapidInStock: 1 },
    verdict: "faults",
  },
  "call-after-change": {
    says: "a cycle called where nobody knows the start point is not proved",
    has: { startUnknown: true, notProved: true },
    mostErrors: 0,
    verdict: "incomplete",
  },
  "cut-from-nowhere": {
    says: "a feed from where nobody knows is not proved",
    has: { startUnknown: 1, notProved: 1 },
    mostErrors: 0,
    verdict: "incomplete",
  },
  "axis-821": { says: "a shoulder to X0 is faced clean", ...clean, cleanAtAxis: true },
  "axis-821-rough": { says: "so it is where nothing finishes it", ...clean, cleanAtAxis: true, hasNot: ["materialLeft"] },
  "axis-821-past": { says: "a shoulder past the axis is faced clean", ...clean, cleanAtAxis: true, mostErrors: 0, verdict: "proved" },
  "axis-821-past-rough": { says: "so it is where nothing finishes it", ...clean, cleanAtAxis: true, mostErrors: 0 },
  "axis-820": { says: "a contour that ends on the axis is faced clean", ...clean, cleanAtAxis: true },
  "axis-810-from-0": { says: "a contour that begins on the axis leaves no pip", ...clean, cleanAtAxis: true },
  "lift-inside": { says: "in a bore no lift comes nearer to the axis than the start point", ...clean, notNearer: 27, mostErrors: 0 },
  "bore-in-solid": {
    says: "boring where there is no bore is refused for that reason",
    has: { boreMissing: 1 },
    mostErrors: 1,
    offersNoNegative: true,
    verdict: "faults",
  },
  "bore-in-solid-faced": { says: "so it is when the face was turned before", has: { boreMissing: 1 }, mostErrors: 1 },
  "bore-in-bore": { says: "the bore that is asked for is enough", hasNot: ["boreMissing"], mostErrors: 0 },
  "blind-bore-too-deep": {
    says: "a bore that ends before the cycle does is told where it ends",
    has: { boreMissing: 1 },
    mostErrors: 1,
    offersNoNegative: true,
    verdict: "faults",
  },
  "j10-820-lblbeforeM30": { says: "M30 is missing in front of the label: the cause, once", mostErrors: 1 },
  "r08-820-Q463-tiny": { says: "too many passes, at once", has: { tooManyPasses: true } },
  "thread-relief-p2": {
    says: "a thread of pitch 2 into its relief at a shoulder, with the tool that ships",
    ...clean,
    mostErrors: 0,
    verdict: "proved",
  },
  "thread-relief-p15": { says: "the same of pitch 1.5", ...clean, mostErrors: 0, verdict: "proved" },
  "thread-relief-inside": {
    says: "the same in a bore, whose relief is deeper than the thread",
    ...clean,
    mostErrors: 0,
    verdict: "proved",
  },
  "thread-m24-to-a-shoulder": {
    says: "M24 into a recess at a shoulder",
    ...clean,
    mostErrors: 0,
    hasNot: ["crestMissing"],
    verdict: "proved",
  },
  "thread-npt-inside": {
    says: "a thread on a cone in a bore",
    ...clean,
    mostErrors: 0,
    hasNot: ["crestMissing", "airPasses"],
    verdict: "proved",
  },
  "thread-flank-at-shoulder": {
    says: "a flank that meets the shoulder says so",
    gouge: true,
    has: { threadOverruns: 1 },
    hasNot: ["gouge"],
    verdict: "faults",
  },
  "thread-end-no-run-out": {
    says: "a thread that overruns into the shaft says so",
    gouge: true,
    has: { threadOverruns: 1 },
    hasNot: ["gouge"],
    verdict: "faults",
  },
  "thread-end-run-out": { says: "and with a run-out it does not", ...clean, hasNot: ["threadOverruns"], mostErrors: 0, verdict: "proved" },
  "thread-thin-shaft": {
    says: "a shaft too thin for its thread, and the passes that cut nothing",
    ...clean,
    has: { crestMissing: 1, airPasses: 1 },
    mostErrors: 0,
  },
  "thread-wide-bore": { says: "a bore too wide for its thread", ...clean, has: { crestMissing: 1, airPasses: 1 }, mostErrors: 0 },
  "thread-size-right": {
    says: "a shaft of the right size",
    ...clean,
    hasNot: ["crestMissing", "airPasses", "threadSurfaceSpeed"],
    mostErrors: 0,
  },
  "thread-constant-surface-speed": {
    says: "a thread at a constant surface speed",
    ...clean,
    has: { threadSurfaceSpeed: 1 },
    mostErrors: 0,
  },
  "thread-face-constant-surface-speed": { says: "the same on a cone", ...clean, has: { threadSurfaceSpeed: 1 }, mostErrors: 0 },
  "thread-from-the-solid": {
    says: "a thread that begins in the solid is refused without a run-in of four times its length",
    has: { runInBlocked: 1 },
    errorAt: ["Q460"],
    mostErrors: 1,
  },
  "relief-inch-m2": {
    says: "0.07874 inch is a pitch of 2 mm",
    ...clean,
    hasNot: ["pitchNotListed", "recessWord"],
    mostErrors: 0,
    verdict: "proved",
  },
  "relief-16-tpi": {
    says: "a pitch that DIN 76 does not list is told as such",
    has: { pitchNotListed: 1 },
    hasNot: ["recessWord"],
    mostErrors: 1,
  },
};
