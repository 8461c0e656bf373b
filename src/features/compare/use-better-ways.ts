import { useEffect, useState } from "react";
import { searchBetterWays, tryBetterWay } from "../../app/calculation/better-ways.ts";
import { onlyNewest } from "../../app/base/once.ts";
import type { ProgramWork } from "../../app/document/work.ts";
import { bestWays, triesOf, type BetterWay } from "../../report/better-ways/better-ways.ts";
import type { Conditions } from "../../report/better-ways/situation.ts";

/** A search with what it has found so far. */
export interface WaySearch {
  readonly of: ProgramWork;
  readonly state: "preparing" | "trying" | "done" | "stopped" | "failed";
  /** The program has faults: only a better check result counts. */
  readonly isFaulty: boolean;
  readonly tried: number;
  readonly count: number;
  /** The best of what was found; the best first once the search has ended. */
  readonly ways: readonly BetterWay[];
  /** What was offered for the program before, until this search ends: to be tried again. */
  readonly stale: readonly BetterWay[];
}

const begun = (of: ProgramWork, stale: readonly BetterWay[]): WaySearch => ({
  of,
  state: "preparing",
  isFaulty: false,
  tried: 0,
  count: 0,
  ways: [],
  stale,
});

/** Searches better ways for a program, one try after the other; another program begins another search. */
export function useBetterWays(
  program: ProgramWork,
  conditions: Omit<Conditions, "tools">,
): { readonly search: WaySearch; readonly stop: () => void; readonly again: () => void } {
  const [search, set] = useState(() => begun(program, []));
  const [round, repeat] = useState(0);
  const [begin] = useState(onlyNewest);
  useEffect(() => {
    const isNewest = begin();
    const tell = (news: Partial<WaySearch>) => set((known) => ({ ...known, ...news }));
    const tryAll = async () => {
      set((known) => begun(program, known.ways));
      const found = await searchBetterWays(program, conditions);
      if (!isNewest()) return;
      if (!found) return tell({ state: "failed", stale: [] });
      const { candidates, baseline } = found;
      tell({ state: "trying", count: candidates.length, isFaulty: baseline.verdict === "faults" });
      const tries = triesOf(found);
      for (let next = tries.next(null); ;) {
        if (next.done) return tell({ state: "done", stale: [], ways: next.value });
        const { candidate, tried, of, ways } = next.value;
        // In the order in which they were found: a row must not move away under the pointer.
        const best = new Set(bestWays(ways));
        tell({ tried, count: of, ways: ways.filter((each) => best.has(each)) });
        const way = await tryBetterWay(program, found, candidate);
        if (!isNewest()) return;
        next = tries.next(way);
      }
    };
    void tryAll();
    return () => void begin();
  }, [program, conditions, round, begin]);
  return {
    search,
    stop: () => {
      begin();
      set((known) => ({ ...known, state: "stopped", stale: [] }));
    },
    again: () => repeat(round + 1),
  };
}
