import { packed } from "../kernel/area/clip.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import type { Checkpoint } from "./simulation.ts";

/** Points of all kept stocks together: 16 bytes each, so 24 MB. */
const MOST_POINTS = 1_500_000;

/** Whether the stock of a mark is not what the cuts before it left. */
export const isGiven = ({ isStated, isParted }: Checkpoint): boolean => (isStated ?? isParted) === true;

/** The marks of a run, with no more kept stocks than fit into memory. */
export interface StockMarks {
  /** `given`: this stock is not what was left before, and is never let go. */
  add(step: number, stock: readonly Ring[], given?: "isStated" | "isParted"): void;
  all(): readonly Checkpoint[];
}

/**
 * Begins to mark, behind marks of which all stocks are kept. When the stocks have more points than are kept, every
 * second one is let go, and then only every second of those that follow is kept: seeking cuts a longer way again, and a
 * run of any length fits into the same memory.
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
          if (i % every !== 0 && m.stock && !isGiven(m)) marks[i] = { step: m.step, stock: null };
        });
        points = marks.reduce((sum, m) => sum + sizeOf(m), 0);
      }
    },
    all: () => marks,
  };
}
