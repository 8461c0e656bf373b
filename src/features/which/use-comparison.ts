import { useEffect, useState } from "react";
import type { ShapeRequest } from "../../cycles/shape-request.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { TriedOption } from "../../report/which/try-way.ts";
import type { Proposal } from "../../report/which/ways.ts";
import type { Comparer } from "../../app/calculation/comparison.ts";
import { untilGone } from "../../app/base/until-gone.ts";

/** Debounce after the last change, ms. */
const DEBOUNCE = 200;

/** The proposals for a shape, and the results simulated so far. */
export interface ComparedProposals {
  readonly wanted: ShapeRequest;
  readonly ways: readonly Proposal[];
  readonly tried: readonly TriedOption[];
  /** The question has changed: these proposals stay until the new ones are ready, and cannot be used. */
  readonly isStale: boolean;
}

/** Simulates the proposals one by one; a new question cancels the previous one. */
export function useComparison(
  wanted: ShapeRequest | null,
  stock: readonly Ring[] | null,
  { ways, tryWay }: Comparer,
): ComparedProposals | null {
  const [compared, set] = useState<Omit<ComparedProposals, "isStale"> | null>(null);
  useEffect(() => {
    if (!wanted) return undefined;
    return untilGone(async (isGone) => {
      const found = (await ways(wanted, stock)) ?? [];
      if (isGone()) return;
      set({ wanted, ways: found, tried: [] });
      for (const way of found) {
        const one = await tryWay(way, wanted, stock);
        if (isGone()) return;
        if (one) set((known) => known && { ...known, tried: [...known.tried, one] });
      }
    }, DEBOUNCE);
  }, [wanted, stock, ways, tryWay]);
  return wanted && compared && { ...compared, isStale: compared.wanted !== wanted };
}
