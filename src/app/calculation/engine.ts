import { Answers } from "../../kernel/answers.ts";
import { cycleByNumber } from "../../cycles/index.ts";
import { knownParameters } from "../../program/job/job-parameters.ts";
import { readDraft } from "../../program/job/read-draft.ts";
import { rankTools, type ToolFit } from "../../program/tools/which-tool.ts";
import { simulate, simulating } from "../../sim/simulate.ts";
import type { FeedUnit } from "../../kernel/plan/move.ts";
import type { Pt } from "../../kernel/geometry/point.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { SetJob } from "../../program/job/job.ts";
import type { Operation } from "../../program/state/run-types.ts";
import { givenOf } from "./given.ts";
import type { Outcome, Stage } from "./outcome.ts";
import { planned, planner } from "./plan.ts";
import type { Request } from "./request.ts";

/** What tools are compared under. */
export interface Circumstances {
  readonly start: Pt;
  readonly feedUnit: FeedUnit;
  readonly tools: readonly Tool[];
}

/** What trying other tools at a call of the run needs of it. */
export type Called = Pick<Operation, "cycle" | "tool" | "feedUnit" | "call">;

/** What an outcome is made by. */
interface Makers {
  readonly planned: typeof planned;
  readonly simulate: typeof simulate;
}
const FRESH: Makers = { planned, simulate };

/**
 * What makes one outcome after the other of the same work: what stays the same is not planned, cut or looked at again.
 */
export function makersAgain(): Makers {
  const answers = new Answers();
  return { planned: planner(answers), simulate: simulating(answers) };
}

/** What every work needs that takes time, as plain functions of plain data. Runs in a worker. */
export const engine = {
  /**
   * From the program text to moves, stock, proof and times. `atStage` is told what it begins; `by` may know the run
   * before.
   */
  update(request: Request, atStage: (stage: Stage) => void = () => undefined, by = FRESH): Outcome {
    const made = by.planned(request, atStage);
    atStage("proving");
    return { ...made, simulation: by.simulate(made.run) };
  },

  /** What each tool can do with the values of a job, best first; null while they make no contour. */
  fits(job: SetJob, { start, feedUnit, tools }: Circumstances): readonly ToolFit[] | null {
    const cycle = cycleByNumber(job.cycle);
    const values = cycle && readDraft(cycle, job.drafts[job.cycle] ?? {}, knownParameters(job)).values;
    if (!cycle || !values) return null;
    const given = givenOf({ cycle, job });
    if (cycle.outline(values, given).issues.some((found) => found.severity === "error")) return null;
    return rankTools(cycle, values, given, { start, feedUnit, autoFeed: null, stock: null }, tools);
  },

  /** What each tool can do in place of the one that was called, best first; null while the call makes no contour. */
  fitsOfCall({ cycle: number, call, feedUnit }: Called, tools: readonly Tool[]): readonly ToolFit[] | null {
    const cycle = cycleByNumber(number);
    if (!cycle || !call) return null;
    return rankTools(
      cycle,
      call.values,
      call.given,
      { start: call.start, feedUnit, autoFeed: call.autoFeed, stock: null },
      tools,
    );
  },
};
