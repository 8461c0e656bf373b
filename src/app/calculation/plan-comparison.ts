import { drawnTask } from "../../course/drawn-task.ts";
import { answerOf } from "../../course/judge/answer.ts";
import { TASK_RAPID } from "../../course/judge/shop.ts";
import { partOfDrawn } from "../../course/part-of-drawn.ts";
import { comparingPlans, type PlanComparison } from "../../course/plans/plan-comparison.ts";
import { toolsOfTask } from "../../course/task-start.ts";
import { shownId, type Task } from "../../course/task.ts";
import type { NcLanguage } from "../../nc/nc-languages.ts";
import { readList } from "../../program/tools/tool-list.ts";
import { planOfPart, requestOf, type PlanOrder } from "./part-plan.ts";

/** How far a comparison is: operations tried by the planner, then differences tried in the learner's program. */
export type ComparingProgress =
  | { readonly kind: "planning"; readonly tries: number }
  | { readonly kind: "trying"; readonly count: number };

/** "noPlan": the drawing states no part that can be planned; "stopped": another search ended this one. */
export type ComparisonAnswer = PlanComparison | "noPlan" | "stopped";

const nextTask = () => new Promise<void>((done) => setTimeout(done));

/**
 * The plan of a learner's program beside that of the planner, which has the same drawing, tools and excluded cycles. In
 * the worker; each difference is one slice.
 */
export async function comparedWithPlan(
  task: Task,
  text: string,
  ncLanguage: NcLanguage,
  tell: (progress: ComparingProgress) => void,
): Promise<ComparisonAnswer> {
  const drawn = drawnTask(task);
  const part = drawn && partOfDrawn(drawn, { name: shownId(task), ...(task.material && { material: task.material }) });
  if (!part) return "noPlan";
  const order: PlanOrder = {
    part,
    withoutTools: [],
    withoutCycles: task.rules.without ?? [],
    usualTools: [],
    ncLanguage,
    shop: { table: readList(toolsOfTask(task)).table, rapid: TASK_RAPID, control: "TNC 640", machine: null },
  };
  const answer = await planOfPart(order, {}, ({ tries }) => tell({ kind: "planning", tries }));
  if (answer.kind !== "planned") return answer.kind === "stopped" ? "stopped" : "noPlan";
  const comparing = comparingPlans(task, answerOf(text), answer.plan, requestOf(order, answer.plan.setup));
  for (let count = 1; ; count += 1) {
    await nextTask();
    const next = comparing.next();
    if (next.done) return next.value;
    tell({ kind: "trying", count });
  }
}
