import type { Move } from "../../kernel/plan/move.ts";
import type { Spindle } from "../../kernel/time/step.ts";
import { speedAt } from "../../kernel/time/time.ts";

/** How the spindle turns, from a step on; null until a speed was programmed. In the order of the steps. */
export interface SpindleFrom {
  readonly step: number;
  readonly spindle: Spindle | null;
  /** The other way round than M3 turns it. */
  readonly backwards?: true;
}

function entryAt(spindles: readonly SpindleFrom[], step: number): SpindleFrom | undefined {
  let [low, high] = [0, spindles.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((spindles[middle]?.step ?? 0) <= step) low = middle + 1;
    else high = middle;
  }
  return spindles[low - 1];
}

/** How the spindle turns at a step. */
export const spindleAt = (spindles: readonly SpindleFrom[], step: number): Spindle | null =>
  entryAt(spindles, step)?.spindle ?? null;

/** Whether it turns the other way round than M3 turns it. */
export const turnsBack = (spindles: readonly SpindleFrom[], step: number): boolean =>
  entryAt(spindles, step)?.backwards ?? false;

/** Spindle speed, rpm, at `r` mm from the axis; not a number where none is known, or none is fast enough. */
export function rpmAt(spindle: Spindle | null, r: number): number {
  const rpm = spindle ? speedAt(spindle, r) : 0;
  return rpm > 0 && Number.isFinite(rpm) ? rpm : NaN;
}

/**
 * Feed in mm a turn of a move at a spindle speed in rpm; not a number for a rapid, and where the speed is not known.
 */
export function feedPerTurn(move: Move, rpm: number): number {
  if (move.kind === "rapid") return NaN;
  if (move.kind === "thread") return Math.abs(move.pitch);
  return move.feedUnit === "mm/rev" ? move.feed : move.feed / rpm;
}
