import { packed } from "../kernel/area/clip.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import type { Checkpoint } from "./simulation.ts";

/** Points of all stored stocks together: 16 bytes each, so 24 MB. */
const MOST_POINTS = 1_500_000;

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
