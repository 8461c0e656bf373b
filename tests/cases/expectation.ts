/** The expected report of a program in this folder. Codes have the severities of `SEVERITY`. */
export interface Expected {
  /** Title of the test. */
  readonly says: string;
  /** Codes that must be reported; with a number, exactly that many of them. */
  readonly has?: Readonly<Record<string, number | true>>;
  readonly hasNot?: readonly string[];
  /** Codes that must be reported, only as infos. */
  readonly infos?: readonly string[];
  readonly mostWarnings?: number;
  /** The only codes that errors may have. */
  readonly errors?: readonly string[];
  /** At most this many errors. */
  readonly mostErrors?: number;
  /** An error that names one of these fields. */
  readonly errorAt?: readonly string[];
  readonly verdict?: "proved" | "faults" | "incomplete";
  /** Whether the proof finds contour damage, mm². */
  readonly gouge?: boolean;
  readonly rapidInStock?: boolean;
  /** Most residual material, mm². */
  readonly left?: number;
  /** Reasons of residual material: one that must be reported, and those limited to the given area. */
  readonly reason?: string;
  readonly noReason?: Readonly<Record<string, number>>;
  readonly unproved?: boolean;
  /**
   * End points of moves outside cycles, in order: [X, Z]. The first position is no move, since its start is unknown.
   */
  readonly path?: readonly (readonly [x: number, z: number])[];
  /** Feeds of the motion outside cycles by block. */
  readonly feeds?: Readonly<Record<number, number>>;
  /** Diameter of the deepest long roughing cut along Z. */
  readonly lastLevel?: number;
  /** Lowest Z that the first operation cuts to. */
  readonly lowestZ?: number;
  /** No finishing cut is along this Z, or passes it by more than the given clearance. */
  readonly finishAlongZ?: { readonly z: number; readonly beyond?: { readonly side: 1 | -1; readonly most: number } };
  /** Circular motion of a block in the X/Z plane: centre [X, Z]. */
  readonly arcInXZ?: Readonly<Record<number, readonly [x: number, z: number]>>;
  /** Every operation makes the same moves from its own start point, and returns there at rapid. */
  readonly alike?: true;
  /** Motion follows the blocks in order. */
  readonly inOrder?: true;
  /** No material is left on the axis. */
  readonly cleanAtAxis?: true;
  /** No motion of an operation comes nearer to the axis than this X. */
  readonly notNearer?: number;
  /** No finding proposes a value below 0. */
  readonly offersNoNegative?: true;
  /** The values that findings propose, in the unit of the program. */
  readonly offers?: readonly number[];
  /** The limits that findings name, in the unit of the program. */
  readonly limits?: readonly number[];
  readonly holder?: "clear" | "contact" | "unknown";
  /** Additional tools, as in a file of tools. */
  readonly tools?: readonly Readonly<Record<string, string | number>>[];
  /** Not fixed yet. */
  readonly pending?: true;
}

/** Severities on which scripts rely. */
export const SEVERITY: Readonly<Record<string, "error" | "warning" | "info">> = {
  notInTurnMode: "error",
  compensationActive: "error",
  toolUnfit: "error",
  labelTwice: "error",
  feedZero: "error",
  feedUnlikely: "warning",
  spindleStopped: "error",
  holeMissing: "error",
  toolLimit: "error",
  toolIndexUnknown: "error",
  firstElement: "error",
  controlRule: "error",
  offCentre: "warning",
  threadSurfaceSpeed: "warning",
  speedUnlimited: "warning",
  speedUnlikely: "warning",
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
  cameLoose: "warning",
  clampContact: "error",
  materialLeft: "warning",
  threadOverruns: "error",
  crestMissing: "warning",
  runInBlocked: "error",
  pitchNotListed: "error",
  boreMissing: "error",
};
