import type { Step } from "../../kernel/time/step.ts";
import { turnsIn } from "../../kernel/time/thread-turns.ts";
import { pathOf, travelOf } from "../../kernel/time/time.ts";
import { feedPerTurn, rpmAt, spindleAt, type SpindleFrom } from "../load/spindles.ts";
import type { PlayPosition } from "../simulation.ts";

/** Most moves within one revolution: shorter moves are a contour of points. */
const MOST = 24;

/** Spindle revolutions in a whole move; NaN where unknown. */
function turnsOf({ from, move }: Step, spindle: ReturnType<typeof spindleAt>): number {
  if (move.kind === "feed" && move.dwell !== undefined) return move.dwell;
  if (move.kind === "thread") return turnsIn(from, move);
  return travelOf(pathOf(from, move)) / feedPerTurn(move, rpmAt(spindle, move.to.r));
}

/**
 * The moment one revolution earlier, across the joined cuts of the same tool. Where those began less than a revolution
 * ago, the start of the first. Null where the feed per revolution is unknown.
 */
export function oneTurnBack(
  steps: readonly Step[],
  { step, fraction }: PlayPosition,
  spindles: readonly SpindleFrom[],
): PlayPosition | null {
  let left = 1;
  for (let s = step, done = fraction; ; s -= 1, done = 1) {
    const running = steps[s],
      turns = running ? turnsOf(running, spindleAt(spindles, s)) : NaN;
    if (!running || !Number.isFinite(turns)) return s === step ? null : { step: s + 1, fraction: 0 };
    if (turns * done >= left) return { step: s, fraction: Math.max(0, done - left / turns) };
    left -= turns * done;
    const before = steps[s - 1];
    const joins =
      before && before.tool === running.tool && before.move.kind !== "rapid" && before.move.kind !== "thread";
    if (!joins || step - s >= MOST) return { step: s, fraction: 0 };
  }
}
