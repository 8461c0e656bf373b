import type { Move } from "../plan/move.ts";
import { part, type Pt } from "../geometry/point.ts";
import { ROUND } from "../tolerance.ts";

/** A move whose feed is locked to the spindle. */
export type ThreadMove = Extract<Move, { kind: "thread" }>;

/** Spindle revolutions of a thread move that begins at `from`. */
export const turnsIn = (from: Pt, move: ThreadMove): number =>
  Math.abs(move.to[move.axis] - from[move.axis]) / move.pitch;

/** 1: a right-handed thread, −1: a left-handed one. */
export type ThreadHand = 1 | -1;

/**
 * Hand of the thread that a move cuts. M3 turns the workpiece clockwise as seen from the headstock: a feed to the
 * headstock cuts a right-handed thread, one away from it a left-handed one; with the spindle turning backwards it is
 * the reverse.
 */
export const handOf = (from: Pt, { to }: ThreadMove, backwards: boolean): ThreadHand =>
  to.z > from.z === backwards ? 1 : -1;

/** A place on the path of a thread move, as a fraction of it. */
export interface Stamp {
  readonly fraction: number;
  readonly at: Pt;
}

/**
 * Tip positions at which the half plane of the stock passes the tool: once per revolution, and at the end where the
 * tool stops. A helix cuts a plane through the axis nowhere else.
 */
export function stampsOf(from: Pt, move: ThreadMove): Stamp[] {
  const turns = turnsIn(from, move);
  const begun = move.angle / 360;
  const out: Stamp[] = [];
  const way = { kind: "line", from, to: move.to } as const;
  if (turns > 0 && Number.isFinite(turns)) {
    for (let turn = Math.ceil(begun - ROUND); turn < begun + turns - ROUND; turn += 1) {
      const fraction = Math.max(0, (turn - begun) / turns);
      out.push({ fraction, at: part.pointOn(way, fraction) });
    }
  }
  if (move.stops) out.push({ fraction: 1, at: move.to });
  return out;
}
