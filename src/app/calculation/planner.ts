import { proxy } from "comlink";
import type { PlanChanges, PlanProgress } from "../../planning/working-plan.ts";
import type { PlanAnswer, PlanOrder, tryValues, ValuesTried } from "./part-plan.ts";
import type { Task } from "../../course/task.ts";
import type { NcLanguage } from "../../nc/nc-languages.ts";
import type { ComparingProgress, ComparisonAnswer } from "./plan-comparison.ts";
import { askAgain } from "./worker-life.ts";

/** The working plan of a part; `tell` gets the best one so far. Null if it cannot be calculated. */
export async function askForPlan(
  order: PlanOrder,
  changes: PlanChanges,
  tell: (progress: PlanProgress) => void,
): Promise<PlanAnswer | null> {
  try {
    return await askAgain(async (engine): Promise<PlanAnswer> => engine.planOfPart(order, changes, proxy(tell)));
  } catch {
    return null;
  }
}

/** What an operation with values set by hand does; null if it cannot be calculated. */
export async function askForValues(...asked: Parameters<typeof tryValues>): Promise<ValuesTried | null> {
  try {
    return await askAgain(async (engine): Promise<ValuesTried> => engine.tryValues(...asked));
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
