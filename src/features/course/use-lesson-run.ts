import { useEffect, useState } from "react";
import type { Outcome } from "../../app/calculation/outcome.ts";
import { runWithShippedTools } from "../../app/calculation/shipped-run.ts";

/** Cached runs, so that previous pages are there at once. */
const MOST_KEPT = 24;

const cachedRuns = new Map<string, Outcome>();

function cacheRun(text: string, outcome: Outcome): void {
  cachedRuns.delete(text);
  cachedRuns.set(text, outcome);
  const [oldest] = cachedRuns.keys();
  if (cachedRuns.size > MOST_KEPT && oldest !== undefined) cachedRuns.delete(oldest);
}

/** The run of a program, of the cached ones if it is among them. */
export async function runOfLesson(text: string): Promise<Outcome> {
  const outcome = cachedRuns.get(text) ?? (await runWithShippedTools(text));
  cacheRun(text, outcome);
  return outcome;
}

/** The results of a lesson's programs. */
export interface LessonRun {
  /** The newest result. While a slider moves, the previous one until the next is ready. */
  readonly outcome: Outcome | null;
  /** The result belongs to another program than requested. */
  readonly isPending: boolean;
  readonly failed: boolean;
}

/** Runs the requested programs one after the other; of the pending ones only the newest. */
function latestOnlyRunner(take: (text: string, outcome: Outcome | null) => void): (text: string) => void {
  let waiting: string | null = null;
  let busy = false;
  const work = async () => {
    busy = true;
    while (waiting !== null) {
      const text: string = waiting;
      waiting = null;
      try {
        take(text, await runOfLesson(text));
      } catch {
        take(text, null);
      }
    }
    busy = false;
  };
  return (text) => {
    waiting = text;
    if (!busy) void work();
  };
}

/** The run of a program; the previous one until it is ready. */
export function useLessonRun(text: string): LessonRun {
  const [made, take] = useState<{ readonly text: string; readonly outcome: Outcome | null } | null>(null);
  const [want] = useState(() =>
    latestOnlyRunner((of, outcome) => take((before) => ({ text: of, outcome: outcome ?? before?.outcome ?? null }))),
  );
  const here = cachedRuns.get(text);
  // A cached run also becomes the previous one.
  const [before, keep] = useState<Outcome | null>(null);
  const newest = here ?? (made?.text === text ? made.outcome : null);
  if (newest && newest !== before) keep(newest);
  useEffect(() => {
    if (!here) want(text);
  }, [here, text, want]);
  const isIt = made?.text === text;
  if (here) return { outcome: here, isPending: false, failed: false };
  return { outcome: before ?? made?.outcome ?? null, isPending: !isIt, failed: isIt };
}
