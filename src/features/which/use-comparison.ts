import { useEffect, useState } from "react";
import type { Wanted } from "../../cycles/wanted.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { Tried } from "../../report/which/try-way.ts";
import type { Proposal } from "../../report/which/ways.ts";
import type { Comparer } from "../../app/calculation/comparison.ts";

/** Rest after the last change before anything is tried, ms. */
const REST = 200;

/** The ways to make what is wanted, and what came of those that have been tried. */
export interface Compared {
  readonly wanted: Wanted;
  readonly ways: readonly Proposal[];
  readonly tried: readonly Tried[];
  /** Something else is wanted by now: these are shown until its own ways are there, and cannot be taken. */
  readonly isOld: boolean;
}

/** Tries the ways one by one; what was asked before is forgotten as soon as something else is wanted. */
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
