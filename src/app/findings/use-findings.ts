import { useMemo } from "react";
import { useOutcome, type Outcome } from "../calculation/outcome.ts";
import { openReading, useReading, type JobReading } from "../document/reading.ts";
import { isToDo, type FindingEntry } from "./entry.ts";
import { findingsOf } from "./findings.ts";
import { shownVerdict, type ShownVerdict } from "./verdict.ts";
import { rememberingLast } from "../base/once.ts";

interface Findings {
  readonly entries: readonly FindingEntry[];
  /** The findings in the list: empty prompts are counted, not listed. */
  readonly listed: readonly FindingEntry[];
  readonly verdict: ShownVerdict;
}

/** Findings and verdict of one state of the open work, cached. */
const known = rememberingLast((read: JobReading | null, newest: Outcome | null): Findings => {
  const entries = findingsOf(read, newest);
  return {
    entries,
    listed: entries.filter((entry) => !isToDo(entry)),
    verdict: shownVerdict(entries, newest && (!read || read.reading.values) ? newest : null),
  };
});

/** The same now, outside of components. */
export const presentFindings = (): Findings => known(openReading(), useOutcome.getState().newest);

function useCurrentFindings(): Findings {
  const read = useReading();
  const newest = useOutcome((s) => s.newest);
  return useMemo(() => known(read, newest), [read, newest]);
}

/** All findings of the open work, worst first; the same list while values and results do not change. */
export const useFindings = (): readonly FindingEntry[] => useCurrentFindings().entries;

/** The findings in the list, which every count on the page uses. */
export const useListed = (): readonly FindingEntry[] => useCurrentFindings().listed;

/** The verdict on the open work. */
export const useVerdict = (): ShownVerdict => useCurrentFindings().verdict;
