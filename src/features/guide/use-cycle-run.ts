import { useEffect, useState } from "react";
import type { Cycle } from "../../cycles/define.ts";
import { makesPath } from "../../report/guide/shown-effect.ts";
import type { Outcome } from "../../app/calculation/outcome.ts";
import { guideSources, simulatedJob } from "./guide-source.ts";
import { takeAnswer } from "../../app/base/until-gone.ts";

/** A run of a cycle, with the operator's values or those of the example. */
export interface CycleRun {
  readonly isOwn: boolean;
  readonly outcome: Outcome;
}

async function runOf(cycle: Cycle): Promise<CycleRun | null> {
  for (const { job, isOwn } of guideSources(cycle)) {
    const outcome = await simulatedJob(job);
    if (outcome && makesPath(outcome)) return { isOwn, outcome };
  }
  return null;
}

/** Simulates a cycle for its guide; undefined while pending, null if that fails. */
export function useCycleRun(cycle: Cycle): CycleRun | null | undefined {
  const [made, put] = useState<{ readonly cycle: Cycle; readonly run: CycleRun | null } | null>(null);
  useEffect(
    () =>
      takeAnswer(
        () => runOf(cycle),
        (run) => put({ cycle, run }),
      ),
    [cycle],
  );
  return made?.cycle === cycle ? made.run : undefined;
}
