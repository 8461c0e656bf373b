import type { Spindle, Step } from "../../kernel/step.ts";
import { turnsIn } from "../../kernel/thread-turns.ts";
import { pathOf, speedAt, travelOf } from "../../kernel/time.ts";
import type { PlayPosition } from "../simulation.ts";

/** Moves that one turn of the spindle is followed back over: shorter ones than that are a contour of points. */
const MOST = 24;

/** Way of the tip in one turn of the spindle, mm: the feed, or the lead of a thread; 0 where the tip goes nowhere, null without a feed. */
export function feedPerTurn({ move }: Step, spindle: Spindle | null, radius: number): number | null {
  if (move.kind === "rapid") return null;
  if (move.kind === "thread") return Math.abs(move.pitch);
  if (move.kind === "feed" && move.dwell !== undefined) return 0;
  if (move.feedUnit === "mm/rev") return move.feed;
  return spindle ? move.feed / speedAt(spindle, radius) : null;
}

/** Turns of the spindle in a whole move; null where none are known. */
function turnsOf(step: Step, spindle: Spindle | null): number | null {
  const { from, move } = step;
  if (move.kind === "feed" && move.dwell !== undefined) return move.dwell;
  if (move.kind === "thread") return turnsIn(from, move);
  const path = pathOf(from, move), feed = feedPerTurn(step, spindle, move.to.r);
  const turns = feed === null ? NaN : travelOf(path) / feed;
  return Number.isFinite(turns) ? turns : null;
}

/**
 * The moment one turn of the spindle earlier, over the cuts of the same tool that lead to this one; where they began less than a turn
 * ago, the beginning of the first of them. Null where the feed of a turn is not known.
 */
export function oneTurnBack(
  steps: readonly Step[],
  { step, fraction }: PlayPosition,
  spindleOf: (step: number) => Spindle | null,
): PlayPosition | null {
  let left = 1;
  for (let s = step, done = fraction;; s -= 1, done = 1) {
    const running = steps[s], turns = running ? turnsOf(running, spindleOf(s)) : null;
    if (!running || turns === null) return s === step ? null : { step: s + 1, fraction: 0 };
    if (turns * done >= left) return { step: s, fraction: Math.max(0, done - left / turns) };
    left -= turns * done;
    const before = steps[s - 1];
    const joins = before && before.tool === running.tool && before.move.kind !== "rapid" && before.move.kind !== "thread";
    if (!joins || step - s >= MOST) return { step: s, fraction: 0 };
  }
}
