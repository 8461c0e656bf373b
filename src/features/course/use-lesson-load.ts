import { useEffect } from "react";
import { CALCULATING } from "../../app/base/waits.ts";
import { loadRequestOf } from "../../app/calculation/load-request.ts";
import type { Outcome } from "../../app/calculation/outcome.ts";
import { askAgain } from "../../app/calculation/worker-life.ts";
import { useMeasuredLoad } from "../../app/pictures/load/load-store.ts";
import type { LoadQuantity } from "../../app/pictures/load/use-load.ts";
import { takeAnswer } from "../../app/base/until-gone.ts";

/** Requests the measurement for the colour map of a run: its surface, or the load on the tool. */
export function useLessonLoad(outcome: Outcome | null, of: LoadQuantity | null): void {
  useEffect(() => {
    if (!outcome || of === null || outcome.run.steps.length === 0) return undefined;
    const { run } = outcome;
    const what = of === "roughness" ? "surface" : "path";
    const measured = useMeasuredLoad.getState();
    if (measured.run === run && measured[what]) return undefined;
    const measure = async (): Promise<Partial<ReturnType<typeof useMeasuredLoad.getState>>> => {
      const request = loadRequestOf(outcome);
      try {
        return of === "roughness"
          ? { surface: await askAgain((engine) => engine.roughness(request)) }
          : { path: await askAgain((engine) => engine.pathLoad(request)) };
      } catch {
        return { failed: true };
      }
    };
    return takeAnswer(
      measure,
      (found) => useMeasuredLoad.setState({ run, path: null, surface: null, failed: false, ...found }),
      CALCULATING.otherTools,
    );
  }, [outcome, of]);
}
