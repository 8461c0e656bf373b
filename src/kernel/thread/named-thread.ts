import { radians, rounded } from "../units.ts";

/** The standards that name threads, one file each. */
export type StandardId =
  | "metric"
  | "unified"
  | "pipe"
  | "taperPipe"
  | "npt"
  | "whitworth"
  | "trapezoidal"
  | "buttress"
  | "round";

/** SizeLimits of a diameter, mm. */
export type SizeLimits = readonly [least: number, greatest: number];

/** Tolerance class with the limits that it gives, mm. */
export interface ThreadTolerance {
  readonly name: string;
  /** Of the crest: major diameter outside, minor diameter inside. */
  readonly crest: SizeLimits;
  readonly pitch: SizeLimits;
}

/** External or internal thread: basic diameters of its design profile, mm; of a taper at its gauge plane. */
export interface ThreadSide {
  /** Shaft before an external thread, bore before an internal one. */
  readonly crest: number;
  readonly pitch: number;
  readonly root: number;
  readonly tolerance?: ThreadTolerance;
}

/** Gauge plane of a taper thread and where the thread begins and ends, mm behind the end face, outside and inside. */
export interface Gauge {
  /** From the small end of the external thread to the gauge plane; an internal thread has it in its face. */
  readonly length: number;
  /** Useful length outside and inside. */
  readonly useful: number;
  readonly usefulInside: number;
}

/** A thread by its name, with the facts of its standard. Lengths mm, angles degrees. */
export interface NamedThread {
  readonly standard: StandardId;
  /** As the standard writes it, without hand and tolerance class. */
  readonly name: string;
  /** False: diameter and pitch are not combined in the standard's tables; computed by its formulas. */
  readonly listed: boolean;
  readonly nominal: number;
  readonly pitch: number;
  readonly perInch?: number;
  readonly starts: number;
  readonly leftHand: boolean;
  /** Angle between the flanks, and both flank angles where they differ. */
  readonly angle: number;
  readonly flanks?: readonly [leading: number, clearing: number];
  /** Its root is flat: an insert of the profile, which no nose radius replaces. */
  readonly flatRoot?: true;
  /** Change of the diameter per length; 0 for a cylinder. */
  readonly taper: number;
  readonly gauge?: Gauge;
  readonly outside: ThreadSide | null;
  readonly inside: ThreadSide | null;
  /** The side that the typed tolerance class or symbol says; null: either. */
  readonly side: "outside" | "inside" | null;
}

/** Where a thread lies in its tolerance: at the basic size of its profile, or in the middle of its class. */
export type Aim = "basic" | "middle";

/** The thread that is cut, mm: crest and root as diameters, depth on the radius. */
export interface CutThread {
  readonly crest: number;
  readonly pitch: number;
  readonly root: number;
  readonly depth: number;
}

/**
 * Nose radius (mm) of an insert that reaches the root with its flanks in place: the radius of a round root, or the one
 * that stands for a flat root.
 */
export function noseOfRoot({ angle, pitch }: Pick<NamedThread, "angle" | "pitch">, side: ThreadSide): number {
  const half = radians(angle) / 2;
  // A groove is half a pitch wide at the pitch diameter.
  const apex = pitch / 4 / Math.tan(half);
  const root = Math.abs(side.pitch - side.root) / 2;
  return Math.max(0, (apex - root) / (1 / Math.sin(half) - 1));
}

const middleOf = ([least, greatest]: SizeLimits): number => (least + greatest) / 2;

/**
 * Diameters of a thread as it is cut. In the middle of its class the crest is in the middle of its limits, and the
 * profile is shifted so that the pitch diameter is.
 */
export function cutThread(side: ThreadSide, aim: Aim): CutThread {
  const { tolerance } = side;
  const wanted = aim === "middle" ? tolerance : undefined;
  const crest = wanted ? middleOf(wanted.crest) : side.crest;
  const pitch = wanted ? middleOf(wanted.pitch) : side.pitch;
  const root = side.root + pitch - side.pitch;
  return {
    crest: rounded(crest),
    pitch: rounded(pitch),
    root: rounded(root),
    depth: rounded(Math.abs(crest - root) / 2),
  };
}

/** Name with hand and tolerance class of a side. */
export function designationOf({ name, leftHand, ...sides }: NamedThread, side: "outside" | "inside"): string {
  const tolerance = sides[side]?.tolerance?.name;
  return [name, tolerance, leftHand ? "LH" : undefined].filter((part) => part !== undefined).join(" ");
}
