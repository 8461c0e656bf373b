import { useEffect, useState } from "react";
import type { Task } from "../../../course/task.ts";
import type { PlanComparison } from "../../../course/plans/plan-comparison.ts";
import { ncLanguageOf } from "../../../i18n/languages.ts";
import type { ComparingProgress } from "../../../app/calculation/plan-comparison.ts";
import { askForComparison, stopPlan } from "../../../app/calculation/planner.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";

/** A comparison with its progress while it is calculated. */
export type ComparisonState =
  | { readonly state: "running"; readonly progress: ComparingProgress | null }
  | { readonly state: "done"; readonly comparison: PlanComparison }
  | { readonly state: "failed" | "noPlan" };

/** Compares the plan of a program with that of the planner while the component is shown. */
export function useComparison(task: Task, text: string): { readonly now: ComparisonState; readonly again: () => void } {
  const [now, set] = useState<ComparisonState>({ state: "running", progress: null });
  const [round, repeat] = useState(0);
  useEffect(() => {
    let isLeft = false;
    const tell = (next: ComparisonState) => !isLeft && set(next);
    const { language } = useSettings.getState();
    tell({ state: "running", progress: null });
    void askForComparison(task, text, ncLanguageOf(language), (progress) => tell({ state: "running", progress })).then(
      (answer) => {
        if (answer === null || answer === "stopped") return tell({ state: "failed" });
        tell(answer === "noPlan" ? { state: "noPlan" } : { state: "done", comparison: answer });
      },
    );
    return () => {
      isLeft = true;
      void stopPlan();
    };
  }, [task, text, round]);
  return { now, again: () => repeat((n) => n + 1) };
}
