import type { Move } from "../../kernel/plan/move.ts";
import type { Spindle } from "../../kernel/time/step.ts";
import { speedAt } from "../../kernel/time/time.ts";

/** The spindle from a step on, in step order; null until a speed was programmed. */
export interface SpindleFrom {
  readonly step: number;
  readonly spindle: Spindle | null;
  /** Against the direction of M3. */
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

/** The spindle at a step. */
export const spindleAt = (spindles: readonly SpindleFrom[], step: number): Spindle | null =>
  entryAt(spindles, step)?.spindle ?? null;

/** Whether the spindle turns against the direction of M3. */
export const turnsBack = (spindles: readonly SpindleFrom[], step: number): boolean =>
  entryAt(spindles, step)?.backwards ?? false;

/** Spindle speed, rpm, at `r` mm from the axis; NaN where unknown or unlimited. */
export function rpmAt(spindle: Spindle | null, r: number): number {
  const rpm = spindle ? speedAt(spindle, r) : 0;
  return rpm > 0 && Number.isFinite(rpm) ? rpm : NaN;
}

/** Feed per revolution of a move at a spindle speed in rpm, mm; NaN for rapids and unknown speeds. */
export function feedPerTurn(move: Move, rpm: number): number {
  if (move.kind === "rapid") return NaN;
  if (move.kind === "thread") return Math.abs(move.pitch);
  return move.feedUnit === "mm/rev" ? move.feed : move.feed / rpm;
}
