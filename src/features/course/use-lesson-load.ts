import { useEffect } from "react";
import { CALCULATING } from "../../app/base/waits.ts";
import { loadRequestOf } from "../../app/calculation/load-request.ts";
import type { Outcome } from "../../app/calculation/outcome.ts";
import { askAgain } from "../../app/calculation/worker-life.ts";
import { useMeasuredLoad } from "../../app/pictures/load/load-store.ts";
import type { LoadQuantity } from "../../app/pictures/load/use-load.ts";

/** Requests the measurement for the colour map of a run: its surface, or the load on the tool. */
export function useLessonLoad(outcome: Outcome | null, of: LoadQuantity | null): void {
  useEffect(() => {
    if (!outcome || of === null || outcome.run.steps.length === 0) return undefined;
    const { run } = outcome;
    const what = of === "roughness" ? "surface" : "path";
    const measured = useMeasuredLoad.getState();
    if (measured.run === run && measured[what]) return undefined;
    let gone = false;
    const put = (found: Partial<ReturnType<typeof useMeasuredLoad.getState>>) => {
      if (!gone) useMeasuredLoad.setState({ run, path: null, surface: null, failed: false, ...found });
    };
    const measure = async () => {
      const request = loadRequestOf(outcome);
      try {
        if (of === "roughness") put({ surface: await askAgain((engine) => engine.roughness(request)) });
        else put({ path: await askAgain((engine) => engine.pathLoad(request)) });
      } catch {
        put({ failed: true });
      }
    };
    const timer = setTimeout(() => void measure(), CALCULATING.otherTools);
    return () => {
      gone = true;
      clearTimeout(timer);
    };
  }, [outcome, of]);
}
