import { AnswerCache } from "../../kernel/answer-cache.ts";
import type { Attempt, Trial } from "../../report/better-ways/situation.ts";
import { variantSimulator } from "../../sim/simulate.ts";
import { planner } from "./plan.ts";
import type { Request } from "./request.ts";

/** A program whose changes are tried: its result, and the trial of a changed text. */
export interface Variants {
  readonly attempt: Attempt;
  readonly trial: (text: string) => Trial;
}

/** Runs a program so that its variants repeat nothing that they have in common with it. */
export function variantsOf(request: Request): Variants {
  const answers = new AnswerCache();
  const plans = planner(answers);
  const { run } = plans(request);
  const { simulation, of } = variantSimulator(run, answers);
  return {
    attempt: { run, simulation },
    trial(text) {
      const made = plans({ ...request, text }).run;
      return { run: made, simulated: () => of(made) };
    },
  };
}
