import type { Pt, Turn } from "../geometry/point.ts";
import type { Degrees, Feed, Length } from "../units.ts";

/** What a move is for. */
export type Phase = "position" | "rough" | "smooth" | "finish" | "thread";
export type FeedUnit = "mm/rev" | "mm/min";

interface Purpose {
  readonly phase: Phase;
  /** Roughing or threading pass, from 1. */
  readonly pass?: number;
  /** Which printed sequence of the manual runs, and the number of the step in it; 0 before step 1. */
  readonly run: "rough" | "finish";
  readonly step: number;
  /** True on an element that falls into the material (Q488 applies). */
  readonly plunging?: true;
}

/** A cutting feed with its unit. */
export interface Feeding {
  readonly feed: Feed;
  readonly feedUnit: FeedUnit;
}

/** A feed that is locked to the turning of the spindle. */
export interface Threading {
  /** Way along `axis` in one turn of the spindle, mm: the lead of the thread, whatever the number of starts. */
  readonly pitch: Length;
  readonly axis: "z" | "r";
  /** Angle of the spindle at which the move begins; each start of a thread has its own. */
  readonly angle: Degrees;
  /** The tool stands still at the end, where it cuts all round; false where the thread goes on. */
  readonly stops: boolean;
}

/**
 * One motion of the theoretical tool tip, from where the tip stands to `to`. Plain data: picture, simulation, time,
 * warnings and goldens all read the same list. A feed that goes nowhere may stand still: `dwell`, turns of the spindle.
 */
export type Move =
  | ({ readonly kind: "rapid"; readonly to: Pt } & Purpose)
  | ({ readonly kind: "feed"; readonly to: Pt; readonly dwell?: number } & Feeding & Purpose)
  | ({ readonly kind: "arc"; readonly to: Pt; readonly centre: Pt; readonly turn: Turn } & Feeding & Purpose)
  | ({ readonly kind: "thread"; readonly to: Pt } & Threading & Purpose);
