import type { Pt, Turn } from "../geometry/point.ts";
import type { Degrees, Feed, Length } from "../units.ts";

/** Purpose of a move. */
export type Phase = "position" | "rough" | "smooth" | "finish" | "thread";
export type FeedUnit = "mm/rev" | "mm/min";

interface Purpose {
  readonly phase: Phase;
  /** Roughing or threading pass, from 1. */
  readonly pass?: number;
  /** The printed sequence of the manual that runs, and the number of its step; 0 before step 1. */
  readonly run: "rough" | "finish";
  readonly step: number;
  /** True on an element that goes down into the material (Q488 applies). */
  readonly plunging?: true;
}

/** A cutting feed with its unit. */
export interface Feeding {
  readonly feed: Feed;
  readonly feedUnit: FeedUnit;
}

/** A feed locked to the rotation of the spindle. */
export interface Threading {
  /** Travel along `axis` per spindle revolution, mm: the lead of the thread, whatever the number of starts. */
  readonly pitch: Length;
  readonly axis: "z" | "r";
  /** Spindle angle at which the move begins; each start of a thread has its own. */
  readonly angle: Degrees;
  /** True if the tool stops at the end, where it cuts all round; false where the thread continues. */
  readonly stops: boolean;
}

/**
 * One motion of the theoretical tool tip, from its position to `to`. Plain data: picture, simulation, time, warnings
 * and goldens all read the same list. A feed without travel may be a dwell: `dwell`, in spindle revolutions.
 */
export type Move =
  | ({ readonly kind: "rapid"; readonly to: Pt } & Purpose)
  | ({ readonly kind: "feed"; readonly to: Pt; readonly dwell?: number } & Feeding & Purpose)
  | ({ readonly kind: "arc"; readonly to: Pt; readonly centre: Pt; readonly turn: Turn } & Feeding & Purpose)
  | ({ readonly kind: "thread"; readonly to: Pt } & Threading & Purpose);
