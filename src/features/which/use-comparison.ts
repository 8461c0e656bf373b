import { useEffect, useState } from "react";
import type { Wanted } from "../../cycles/wanted.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { Tried } from "../../report/which/try-way.ts";
import type { Proposal } from "../../report/which/ways.ts";
import type { Comparer } from "../../app/calculation/comparison.ts";

/** Debounce after the last change, ms. */
const REST = 200;

/** The proposals for a shape, and the results simulated so far. */
export interface Compared {
  readonly wanted: Wanted;
  readonly ways: readonly Proposal[];
  readonly tried: readonly Tried[];
  /** The question has changed: these proposals stay until the new ones are ready, and cannot be used. */
  readonly isOld: boolean;
}

/** Simulates the proposals one by one; a new question cancels the previous one. */
export function useComparison(
  wanted: Wanted | null,
  stock: readonly Ring[] | null,
  { ways, tryWay }: Comparer,
): Compared | null {
  const [compared, set] = useState<Omit<Compared, "isOld"> | null>(null);
  useEffect(() => {
    if (!wanted) return undefined;
    let gone = false;
    const compare = async () => {
      const found = (await ways(wanted, stock)) ?? [];
      if (gone) return;
      set({ wanted, ways: found, tried: [] });
      for (const way of found) {
        const one = await tryWay(way, wanted, stock);
        if (gone) return;
        if (one) set((known) => known && { ...known, tried: [...known.tried, one] });
      }
    };
    const timer = setTimeout(() => void compare(), REST);
    return () => {
      gone = true;
      clearTimeout(timer);
    };
  }, [wanted, stock, ways, tryWay]);
  return wanted && compared && { ...compared, isOld: compared.wanted !== wanted };
}
