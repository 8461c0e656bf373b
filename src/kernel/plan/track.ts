import { segmentToPart, toPart, type Flat, type FlatSegment, type Frame } from "../geometry/flat.ts";
import type { FeedUnit, Move, Phase, Threading } from "./move.ts";
import { feed as asFeed } from "../units.ts";

/** Purpose of the next moves; a track adds it to each of them. */
export interface Purpose {
  readonly phase: Phase;
  readonly run: "rough" | "finish";
  readonly step: number;
  readonly pass?: number;
  readonly plunging?: true;
}

/** Limits of the tip in strategy space. */
export interface Room {
  readonly minU: number;
  readonly maxU: number;
  readonly minV: number;
  readonly maxV: number;
  /**
   * In a bore that is cut across the axis: the smallest distance from the axis when the tool lifts at an angle, as a u.
   */
  readonly nearest?: number;
}

/** Room of the tip: on this side of the axis, and up to `beyond` mm on the other. */
export function roomOf(f: Frame, beyond = 0): Room {
  const [lowU, highU] = f.transverse
    ? f.signU > 0
      ? [-beyond, Infinity]
      : [-Infinity, beyond]
    : [-Infinity, Infinity];
  const [lowV, highV] = f.transverse ? [-Infinity, Infinity] : f.signV > 0 ? [-beyond, Infinity] : [-Infinity, beyond];
  return { minU: lowU, maxU: highU, minV: lowV, maxV: highV };
}

/** Moves shorter than this are rounding, mm. */
const STILL = 2e-6;

/** Collects the moves of a run in strategy space and returns them in part space; moves without travel are dropped. */
export class Track {
  readonly moves: Move[] = [];
  at: Flat;
  protected readonly frame: Frame;
  private readonly feedUnit: FeedUnit;
  private readonly room: Room;

  constructor(frame: Frame, feedUnit: FeedUnit, start: Flat, room: Room) {
    this.frame = frame;
    this.feedUnit = feedUnit;
    this.room = room;
    this.at = start;
  }

  /** Rapid along one axis only, so that a control whose rapids do not interpolate runs the same path. */
  rapid(axis: "u" | "v", value: number, purpose: Purpose) {
    const to = this.inside({ ...this.at, [axis]: value });
    if (this.still(to)) return;
    this.moves.push({ kind: "rapid", to: toPart(this.frame, to), ...purpose });
    this.at = to;
  }

  /** Straight at feed. */
  feed(point: Flat, value: number, purpose: Purpose) {
    const to = this.inside(point);
    if (this.still(to)) return;
    this.moves.push({
      kind: "feed",
      to: toPart(this.frame, to),
      feed: asFeed(value),
      feedUnit: this.feedUnit,
      ...purpose,
    });
    this.at = to;
  }

  /** Dwells for a number of spindle revolutions. */
  dwell(revolutions: number, value: number, purpose: Purpose) {
    if (!(revolutions > 0)) return;
    const to = toPart(this.frame, this.at);
    this.moves.push({ kind: "feed", to, dwell: revolutions, feed: asFeed(value), feedUnit: this.feedUnit, ...purpose });
  }

  /** Straight, locked to the spindle. */
  thread(point: Flat, locked: Threading, purpose: Purpose) {
    const to = this.inside(point);
    if (this.still(to)) return;
    this.moves.push({ kind: "thread", to: toPart(this.frame, to), ...locked, ...purpose });
    this.at = to;
  }

  /** Along an element at feed; an arc stays an arc. */
  follow(segment: FlatSegment, value: number, purpose: Purpose) {
    if (segment.kind === "line") return this.feed(segment.to, value, purpose);
    if (this.still(segment.to)) return;
    const part = segmentToPart(this.frame, segment);
    if (part.kind === "arc")
      this.moves.push({
        kind: "arc",
        to: part.to,
        centre: part.centre,
        turn: part.turn,
        feed: asFeed(value),
        feedUnit: this.feedUnit,
        ...purpose,
      });
    this.at = segment.to;
  }

  /** To the start of a path and along it; `how` gives feed and purpose of each element. */
  along(path: readonly FlatSegment[], how: (s: FlatSegment) => { readonly feed: number; readonly purpose: Purpose }) {
    path.forEach((s, i) => {
      const step: FlatSegment = { kind: "line", from: this.at, to: s.from };
      if (i === 0) this.feed(s.from, how(step).feed, how(step).purpose);
      this.follow(s, how(s).feed, how(s).purpose);
    });
  }

  private inside(p: Flat): Flat {
    const r = this.room;
    return { u: Math.min(Math.max(p.u, r.minU), r.maxU), v: Math.min(Math.max(p.v, r.minV), r.maxV) };
  }

  private still(p: Flat) {
    return Math.abs(p.u - this.at.u) < STILL && Math.abs(p.v - this.at.v) < STILL;
  }
}
