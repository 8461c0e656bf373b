import { proxy } from "comlink";
import type { PlanProgress } from "../../planning/working-plan.ts";
import type { PlanAnswer, PlanOrder } from "./part-plan.ts";
import type { Task } from "../../course/task.ts";
import type { NcLanguage } from "../../nc/nc-languages.ts";
import type { ComparingProgress, ComparisonAnswer } from "./plan-comparison.ts";
import { askAgain } from "./worker-life.ts";

/** The working plan of a part; `tell` gets the best one so far. Null if it cannot be calculated. */
export async function askForPlan(order: PlanOrder, tell: (progress: PlanProgress) => void): Promise<PlanAnswer | null> {
  try {
    return await askAgain(async (engine): Promise<PlanAnswer> => engine.planOfPart(order, proxy(tell)));
  } catch {
    return null;
  }
}

/** The plan of an answer to an exercise beside that of the planner. Null if it cannot be calculated. */
export async function askForComparison(
  task: Task,
  text: string,
  ncLanguage: NcLanguage,
  tell: (progress: ComparingProgress) => void,
): Promise<ComparisonAnswer | null> {
  try {
    return await askAgain(async (engine): Promise<ComparisonAnswer> =>
      engine.comparePlan(task, text, ncLanguage, proxy(tell)),
    );
  } catch {
    return null;
  }
}

/** Stops the search in progress: its answer is "stopped". */
export const stopPlan = async (): Promise<void> => askAgain((engine) => engine.stopPlanning());
