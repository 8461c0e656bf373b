import { useCallback } from "react";
import type { Cycle } from "../../cycles/define.ts";
import type { SomeValues } from "../../cycles/effect.ts";
import type { Box } from "../../kernel/geometry/segments.ts";
import type { SetJob } from "../../program/job.ts";
import { makesPath } from "../../report/guide/shown-effect.ts";
import { neededFor, threeValues, type Candidates } from "../../report/guide/three-values.ts";
import { readJob } from "../reading.ts";
import { guideSources, ranBeside, useGuideSource } from "./guide-source.ts";
import { compared, type RanValue, type TriedOutcome } from "./tried.ts";
import { useMade, type MadeForPage } from "./use-made.ts";

/** A value with what comes of it. */
export interface TriedValue extends TriedOutcome {
  readonly value: number | "auto";
}

/** A parameter shown at its values. */
export interface TriedValues {
  readonly isOwn: boolean;
  /** The value that stands in the work, or in the example. */
  readonly usual: number | "auto";
  /** Other values that had to be changed so that something is seen, by Q. */
  readonly needed: Readonly<Record<string, number>>;
  readonly tried: readonly TriedValue[];
  readonly box: Box;
}

const typed = (value: number | "auto") => (value === "auto" ? "FAUTO" : String(value));

const jobWith = (job: SetJob, values: Readonly<Record<string, number | "auto">>): SetJob => ({
  ...job,
  drafts: {
    ...job.drafts,
    [job.cycle]: { ...job.drafts[job.cycle], ...Object.fromEntries(Object.entries(values).map(([q, value]) => [q, typed(value)])) },
  },
});

/** The first candidate that makes a path, run; the last one with what is wrong with it where none does. */
async function firstThatRuns(job: SetJob, q: string, { tried, isUsual }: Candidates, goesOn: () => boolean) {
  let last: (RanValue & { readonly value: number | "auto" }) | null = null;
  for (const value of tried) {
    if (!goesOn()) return null;
    const outcome = await ranBeside(jobWith(job, { [q]: value }));
    if (outcome) last = { value, isUsual, outcome };
    if (outcome && makesPath(outcome)) break;
  }
  return last;
}

/** Runs a cycle with the values that show a parameter; null where the cycle makes no path at all. */
async function tryValues(cycle: Cycle, q: string, goesOn: () => boolean): Promise<TriedValues | null> {
  for (const { job, isOwn } of guideSources(cycle)) {
    const values = readJob(job)?.reading.values as SomeValues | null | undefined;
    if (!values) continue;
    const needed = neededFor(cycle, q, values);
    const withNeeded = jobWith(job, needed);
    const usual = values[q] ?? cycle.params[q]?.example ?? 0;
    const found = [];
    for (const candidates of threeValues(cycle, q, { ...values, ...needed, [q]: usual }))
      found.push(await firstThatRuns(withNeeded, q, candidates, goesOn));
    const shown = compared(found.filter((each) => each !== null));
    if (shown) return { isOwn, usual, needed, ...shown };
  }
  return null;
}

/** A parameter at its values, run again when the open work changes; what was shown stays until then. */
export function useTriedValues(cycle: Cycle, q: string): MadeForPage<TriedValues> {
  const make = useCallback((goesOn: () => boolean) => tryValues(cycle, q, goesOn), [cycle, q]);
  return useMade(`${cycle.number}/${q}`, useGuideSource(cycle), make);
}
