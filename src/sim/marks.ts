import { packed } from "../kernel/area/clip.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import type { Checkpoint } from "./simulation.ts";

/** Points of all stored stocks together: 16 bytes each, so 24 MB. */
const MOST_POINTS = 1_500_000;

/** Moves from one checkpoint to the next, and convex pieces that trigger an earlier one: long arcs have many. */
const [CHECKPOINT_STEPS, CHECKPOINT_PIECES] = [50, 400];
/** From this move on checkpoints lie farther apart, in proportion to the moves before them. */
const FEW_STEPS = 10_000;

/**
 * Whether the stock is recomputed before a step; `marked`: the step where it was last, `pieces`: convex pieces since
 * then. It depends on nothing behind that step, so a longer run has the same checkpoints in its beginning.
 */
export function isCheckpointDue(step: number, marked: number, pieces: number): boolean {
  const share = Math.max(1, marked / FEW_STEPS);
  return step - marked >= CHECKPOINT_STEPS * share || pieces >= CHECKPOINT_PIECES * share;
}

/** Whether the stock of a mark was replaced (stated or split), not left by the cuts before it. */
export const isStockReplaced = ({ isStated, isParted }: Checkpoint): boolean => (isStated ?? isParted) === true;

/** The marks of a run, with as many stored stocks as fit into memory. */
export interface StockMarks {
  /** `given`: the stock was replaced here, so it is never dropped. */
  add(step: number, stock: readonly Ring[], given?: "isStated" | "isParted"): void;
  all(): readonly Checkpoint[];
}

/**
 * Starts after earlier marks whose stocks are all stored. Above the point limit every second stock is dropped, and from
 * then on only every second is stored: seeking recomputes longer stretches, but a run of any length fits into the same
 * memory.
 */
export function marksOf(before: readonly Checkpoint[] = [], most = MOST_POINTS): StockMarks {
  const marks = [...before];
  const sizeOf = ({ stock }: Checkpoint) => (stock ?? []).reduce((sum, ring) => sum + ring.length / 2, 0);
  let [every, points] = [1, marks.reduce((sum, m) => sum + sizeOf(m), 0)];
  return {
    add(step, stock, given) {
      const kept = given !== undefined || marks.length % every === 0;
      const mark: Checkpoint = { step, stock: kept ? packed(stock) : null, ...(given && { [given]: true }) };
      marks.push(mark);
      points += sizeOf(mark);
      while (points > most && every < marks.length) {
        every *= 2;
        marks.forEach((m, i) => {
          if (i % every !== 0 && m.stock && !isStockReplaced(m)) marks[i] = { step: m.step, stock: null };
        });
        points = marks.reduce((sum, m) => sum + sizeOf(m), 0);
      }
    },
    all: () => marks,
  };
}
