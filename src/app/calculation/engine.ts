import { AnswerCache } from "../../kernel/answer-cache.ts";
import { cycleByNumber } from "../../cycles/index.ts";
import { knownParameters } from "../../program/job/job-parameters.ts";
import { readDraft } from "../../program/job/read-draft.ts";
import { rankTools, type ToolFit } from "../../program/tools/which-tool.ts";
import { simulate, incrementalSimulator } from "../../sim/simulate.ts";
import type { FeedUnit } from "../../kernel/plan/move.ts";
import type { Pt } from "../../kernel/geometry/point.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { SetJob } from "../../program/job/job.ts";
import type { Operation } from "../../program/state/run-types.ts";
import { cycleGivens } from "./cycle-givens.ts";
import type { AtStage, Outcome } from "./outcome.ts";
import { planned, planner } from "./plan.ts";
import type { Request } from "./request.ts";

/** The conditions for comparing tools. */
export interface Circumstances {
  readonly start: Pt;
  readonly feedUnit: FeedUnit;
  readonly tools: readonly Tool[];
}

/** The data of a call that are needed to try other tools. */
export type CalledCycle = Pick<Operation, "cycle" | "tool" | "feedUnit" | "call">;

/** The functions that make a result. */
interface Makers {
  readonly planned: typeof planned;
  readonly simulate: typeof simulate;
}
const FRESH: Makers = { planned, simulate };

/** Functions for successive results of one work: unchanged parts are not planned, cut or checked again. */
export function makersAgain(): Makers {
  const answers = new AnswerCache();
  return { planned: planner(answers), simulate: incrementalSimulator(answers) };
}

/** The slow calculations that every work needs, as pure functions of plain data. They run in a worker. */
export const engine = {
  /**
   * From the program text to moves, stock, check and times. `atStage` is called as each stage begins; `by` may reuse
   * the previous run.
   */
  update(request: Request, atStage: AtStage = () => undefined, by = FRESH): Outcome {
    const made = by.planned(request, atStage);
    atStage("proving");
    return { ...made, simulation: by.simulate(made.run, (share) => atStage("proving", share)) };
  },

  /** What each tool can do with the values of a job, best first; null while they make no contour. */
  fits(job: SetJob, { start, feedUnit, tools }: Circumstances): readonly ToolFit[] | null {
    const cycle = cycleByNumber(job.cycle);
    const values = cycle && readDraft(cycle, job.drafts[job.cycle] ?? {}, knownParameters(job)).values;
    if (!cycle || !values) return null;
    const given = cycleGivens({ cycle, job });
    if (cycle.outline(values, given).issues.some((found) => found.severity === "error")) return null;
    return rankTools(cycle, values, given, { start, feedUnit, autoFeed: null, stock: null }, tools);
  },

  /** What each tool can do in place of the one that was called, best first; null while the call makes no contour. */
  fitsOfCall({ cycle: number, call, feedUnit }: CalledCycle, tools: readonly Tool[]): readonly ToolFit[] | null {
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
