import type { Step } from "../../kernel/time/step.ts";
import { turnsIn } from "../../kernel/time/thread-turns.ts";
import { pathOf, travelOf } from "../../kernel/time/time.ts";
import { feedPerTurn, rpmAt, spindleAt, type SpindleFrom } from "../load/spindles.ts";
import type { PlayPosition } from "../simulation.ts";

/** Moves that one turn of the spindle is followed back over: shorter ones than that are a contour of points. */
const MOST = 24;

/** Turns of the spindle in a whole move; not a number where none are known. */
function turnsOf({ from, move }: Step, spindle: ReturnType<typeof spindleAt>): number {
  if (move.kind === "feed" && move.dwell !== undefined) return move.dwell;
  if (move.kind === "thread") return turnsIn(from, move);
  return travelOf(pathOf(from, move)) / feedPerTurn(move, rpmAt(spindle, move.to.r));
}

/**
 * The moment one turn of the spindle earlier, over the cuts of the same tool that lead to this one; where they began
 * less than a turn ago, the beginning of the first of them. Null where the feed of a turn is not known.
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
