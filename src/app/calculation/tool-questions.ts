import type { Tool } from "../../kernel/plan/tool.ts";
import type { Job, SetJob } from "../../program/job/job.ts";
import type { Operation } from "../../program/state/run-types.ts";
import type { ToolFit } from "../../program/tools/which-tool.ts";
import type { Remedy } from "../../report/remedies.ts";
import type { Residual } from "../../sim/simulation.ts";
import { completeJob } from "../document/reading.ts";
import { toolTable } from "../document/work-tools.ts";
import type { CalledCycle } from "./engine.ts";
import type { Outcome } from "./outcome.ts";
import { askAgain } from "./worker-life.ts";

/*
 * Requests to the worker about tools: which of the table suit the open work, and which remove the residual material of
 * an operation.
 */

const calledOf = ({ cycle, tool, feedUnit, call }: Operation): CalledCycle => ({ cycle, tool, feedUnit, call });

/**
 * What each tool of the table can do in place of the one an operation called, best first; null if it cannot be
 * calculated.
 */
export async function fitsOfCall(operation: Operation): Promise<readonly ToolFit[] | null> {
  try {
    return await askAgain((engine) => engine.fitsOfCall(calledOf(operation), toolTable().tools));
  } catch {
    return null;
  }
}

/**
 * The tools of the table that would remove an operation's residual material, least left first; null if it cannot be
 * calculated.
 */
export async function remediesOf(operation: Operation, left: Residual): Promise<readonly Remedy[] | null> {
  try {
    return await askAgain((engine) => engine.remediesOf(calledOf(operation), left, toolTable().tools));
  } catch {
    return null;
  }
}

/** What each tool of the table can do with the values of a job, best first; null if it cannot be calculated. */
export async function fitsOf(job: Job, outcome: Outcome): Promise<readonly ToolFit[] | null> {
  const { operations } = outcome.run;
  const call = operations[0];
  if (!call) return null;
  try {
    return await askAgain((engine) =>
      engine.fits(completeJob(job), { start: call.start, feedUnit: call.feedUnit, tools: toolTable().tools }),
    );
  } catch {
    return null;
  }
}

/** The same for a work that has not been run, from its own start point. */
export async function fitsOfWork(
  job: SetJob,
  tools: readonly Tool[] = toolTable().tools,
): Promise<readonly ToolFit[] | null> {
  try {
    return await askAgain((engine) => engine.fitsOfWork(job, tools));
  } catch {
    return null;
  }
}
