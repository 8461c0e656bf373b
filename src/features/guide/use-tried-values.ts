import { useCallback } from "react";
import type { Cycle } from "../../cycles/define.ts";
import type { Box } from "../../kernel/geometry/segments.ts";
import type { SetJob } from "../../program/job/job.ts";
import { demonstrate } from "../../report/guide/demonstrate.ts";
import { cycleGivens } from "../../app/calculation/cycle-givens.ts";
import { readJob } from "../../app/document/reading.ts";
import { guideSources, simulatedJob, useGuideSource } from "./guide-source.ts";
import { comparedValues, type ComparedValue } from "./compared-values.ts";
import { usePageResult, type PageResult } from "./use-page-result.ts";

/** A value with its effect. */
export interface TriedValue extends ComparedValue {
  readonly value: number | "auto";
}

/** A parameter at several values. */
export interface TriedValues {
  readonly isOwn: boolean;
  /** The present value of the work, or of the example. */
  readonly standing: number | "auto" | undefined;
  /** Other values that had to be changed to make the effect visible, by Q. */
  readonly needed: Readonly<Record<string, number>>;
  /** Some of the values look like another one. */
  readonly isUnseen: boolean;
  readonly tried: readonly TriedValue[];
  readonly box: Box;
}

const typed = (value: number | "auto") => (value === "auto" ? "FAUTO" : String(value));

const jobWith = (job: SetJob, values: Readonly<Record<string, number | "auto">>): SetJob => ({
  ...job,
  drafts: {
    ...job.drafts,
    [job.cycle]: {
      ...job.drafts[job.cycle],
      ...Object.fromEntries(Object.entries(values).map(([q, value]) => [q, typed(value)])),
    },
  },
});

/**
 * Simulates a cycle with values that show the effect of a parameter: on the open work, or on the example if nothing is
 * visible on the work; null if the cycle makes no path at all.
 */
async function tryValues(cycle: Cycle, q: string, goesOn: () => boolean): Promise<TriedValues | null> {
  let best: TriedValues | null = null;
  for (const { job, isOwn } of guideSources(cycle)) {
    const read = readJob(job),
      values = read?.reading.values as Readonly<Record<string, number | "auto">> | null | undefined;
    if (!read || !values) continue;
    const asked = { cycle, q, values, given: cycleGivens(read) };
    const found = await demonstrate(asked, (changed) =>
      goesOn() ? simulatedJob(jobWith(job, changed)) : Promise.resolve(null),
    );
    const shown = found && comparedValues(found.valueRuns);
    if (!found || !shown) continue;
    const { [q]: _, ...needed } = found.needed;
    const here: TriedValues = { isOwn, standing: values[q], needed, isUnseen: found.alikeCount > 0, ...shown };
    if (!here.isUnseen) return here;
    best ??= here;
  }
  return best;
}

/** A parameter at several values, recomputed when the open work changes; the previous ones are shown until then. */
export function useTriedValues(cycle: Cycle, q: string): PageResult<TriedValues> {
  const make = useCallback((goesOn: () => boolean) => tryValues(cycle, q, goesOn), [cycle, q]);
  return usePageResult(`${cycle.number}/${q}`, useGuideSource(cycle), make);
}
