import { stopwatch } from "../base/clock.ts";
import { engine, makersAgain } from "./engine.ts";
import type { AtStage, Outcome, Planned } from "./outcome.ts";
import { proofDelta, type ProofDelta } from "./proof-delta.ts";
import type { Request } from "./request.ts";

/** Calculates successive states of the open work, reusing unchanged parts. Runs in the worker. */
export function openWork() {
  const makers = makersAgain();
  let newest: Outcome | null = null;
  /** The run that was sent last, before its check: it is not planned twice. */
  let ahead: Planned | null = null;

  /** The result with the time of its run. Version 0 is a program other than the open work. */
  function update(request: Request, tell: AtStage = () => undefined): Outcome {
    const begun = stopwatch();
    let pace = 0;
    const stageOf: AtStage = (stage, share = 0) => {
      if (stage === "proving" && share === 0) pace = stopwatch() - begun;
      tell(stage, share);
    };
    if (request.version === 0) return engine.update(request, stageOf);
    const made = ahead?.version === request.version ? ahead : null;
    newest = engine.update(request, stageOf, made ? { ...makers, planned: () => made } : makers);
    return { ...newest, pace };
  }

  return {
    update,

    /** The run of a request; `proved` then sends its check. */
    planned(request: Request, tell?: AtStage): Planned {
      const begun = stopwatch();
      ahead = makers.planned(request, tell);
      return { ...ahead, pace: stopwatch() - begun };
    },

    /**
     * The check of a request whose run the page has, without the checkpoints that the page has as well if `has` is the
     * version of the last answer.
     */
    proved(request: Request, has: number | null, tell?: AtStage): ProofDelta {
      const before = newest?.version === has ? newest : null;
      return proofDelta(update(request, tell).simulation, before?.simulation.checkpoints ?? []);
    },

    /** The newest result: later requests about it need not send it again. */
    newest: (): Outcome | null => newest,
  };
}
