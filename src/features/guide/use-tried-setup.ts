import { useCallback } from "react";
import type { Cycle } from "../../cycles/define.ts";
import { toolTable } from "../../app/document/work-tools.ts";
import { guideSources, simulatedJob, useGuideSource } from "./guide-source.ts";
import { setupVariants, type SetupPageId } from "./setup-variants.ts";
import { comparedValues, type SimulatedValue, type ComparedValue } from "./compared-values.ts";
import { usePageResult, type PageResult } from "./use-page-result.ts";
import type { Box } from "../../kernel/geometry/segments.ts";

/** A place of the set-up at several values. */
export interface TriedSetup {
  readonly isOwn: boolean;
  readonly tried: readonly (ComparedValue & { readonly value: number })[];
  readonly box: Box;
}

/** Simulates a cycle with other values at a place of its set-up; null if it makes no path. */
async function trySetup(cycle: Cycle, id: SetupPageId, goesOn: () => boolean): Promise<TriedSetup | null> {
  for (const { job, isOwn } of guideSources(cycle)) {
    const ran: (SimulatedValue & { readonly value: number })[] = [];
    for (const { value, isUsual, job: other } of setupVariants(id, job, toolTable().tools)) {
      if (!goesOn()) return null;
      const outcome = await simulatedJob(other);
      if (outcome) ran.push({ value, isUsual, outcome });
    }
    const shown = comparedValues(ran);
    if (shown) return { isOwn, ...shown };
  }
  return null;
}

/** A place of the set-up at several values, recomputed when the open work changes. */
export function useTriedSetup(cycle: Cycle, id: SetupPageId): PageResult<TriedSetup> {
  const make = useCallback((goesOn: () => boolean) => trySetup(cycle, id, goesOn), [cycle, id]);
  return usePageResult(`${cycle.number} ${id}`, useGuideSource(cycle), make);
}
