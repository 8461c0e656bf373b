import { parse } from "../nc/parse.ts";
import { printJob, type Labels } from "../program/job/print-job.ts";
import { setupOf, withSetup } from "../program/job/setup.ts";
import { shippedTools } from "../program/tools/shipped-tools.ts";
import type { Draft } from "../program/job/read-draft.ts";
import { startOfTask } from "./task-start.ts";
import type { Task } from "./task.ts";

/** NC words for text that nobody reads. */
const PLAIN: Labels = { cycleName: String, label: (text) => text, contour: { title: "CONTOUR", label: "LABEL" } };

/** The program of the starting prompts, with other values in them; null where a task starts otherwise. */
export function promptsText(task: Task, values?: Draft): string | null {
  const begun = startOfTask(task);
  if (begun.kind !== "job") return null;
  const job = values ? { ...begun.job, drafts: { [begun.job.cycle]: values } } : begun.job;
  return printJob(withSetup(job, setupOf(job, shippedTools)), PLAIN);
}

/** The solution's values for the starting cycle; null where the solution does not call it. */
export function solutionValues({ start, solution }: Task): Draft | null {
  if (!("cycle" in start) || !solution) return null;
  const { blocks } = parse(solution.join("\n"));
  const found = blocks.find(({ statement: s }) => s.kind === "cycle" && s.cycle === start.cycle)?.statement;
  return found?.kind === "cycle"
    ? Object.fromEntries(
        found.parameters.flatMap(({ q, value }) => (typeof value === "number" ? [[q, String(value)]] : [])),
      )
    : null;
}
