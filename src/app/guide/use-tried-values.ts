import { useEffect, useState } from "react";
import type { Cycle } from "../../cycles/define.ts";
import type { SomeValues } from "../../cycles/effect.ts";
import type { Box } from "../../kernel/geometry/segments.ts";
import type { SetJob } from "../../program/job.ts";
import { makesPath, shownBox, shownChange, shownEffect, type ShownChange, type ShownEffect } from "../../report/guide/shown-effect.ts";
import { neededFor, threeValues, type Candidates } from "../../report/guide/three-values.ts";
import type { Outcome } from "../engine/outcome.ts";
import { readJob } from "../reading.ts";
import { guideSources, ranBeside, useGuideSource } from "./guide-source.ts";

/** A value with what comes of it. */
export interface TriedValue {
  readonly value: number | "auto";
  readonly isUsual: boolean;
  readonly outcome: Outcome;
  readonly effect: ShownEffect;
  /** Against the usual value; null for that itself. */
  readonly change: ShownChange | null;
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
  let last: { readonly value: number | "auto"; readonly isUsual: boolean; readonly outcome: Outcome } | null = null;
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
    const shown = jobWith(job, needed);
    const usual = values[q] ?? cycle.params[q]?.example ?? 0;
    const found = [];
    for (const candidates of threeValues(cycle, q, { ...values, ...needed, [q]: usual }))
      found.push(await firstThatRuns(shown, q, candidates, goesOn));
    const ran = found.filter((each) => each !== null);
    const compared = ran.find((each) => each.isUsual && makesPath(each.outcome));
    if (!compared) continue;
    const tried = ran.map((each): TriedValue => ({
      ...each,
      effect: shownEffect(each.outcome),
      change: each === compared || !makesPath(each.outcome) ? null : shownChange(each.outcome, compared.outcome),
    }));
    return { isOwn, usual, needed, tried, box: shownBox(ran.map(({ outcome }) => outcome)) };
  }
  return null;
}

/** What was shown of a parameter last, and whether it is being run again with values that have changed since. */
export interface ShownValues {
  /** Undefined until it has run once, null where nothing can be shown. */
  readonly values: TriedValues | null | undefined;
  readonly working: boolean;
}

/** A parameter at its values, run again when the open work changes; what was shown stays until then. */
export function useTriedValues(cycle: Cycle, q: string): ShownValues {
  const [made, put] = useState<{ readonly of: string; readonly source: string; readonly values: TriedValues | null } | null>(null);
  const of = `${cycle.number}/${q}`;
  const source = useGuideSource(cycle);
  useEffect(() => {
    let gone = false;
    void tryValues(cycle, q, () => !gone).then((values) => {
      if (!gone) put({ of: `${cycle.number}/${q}`, source, values });
    });
    return () => {
      gone = true;
    };
  }, [cycle, q, source]);
  const isOf = made?.of === of;
  return { values: isOf ? made.values : undefined, working: !isOf || made.source !== source };
}
