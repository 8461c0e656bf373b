import { stopwatch } from "../base/clock.ts";
import { engine, makersAgain } from "./engine.ts";
import type { Outcome, Planned, Stage } from "./outcome.ts";
import { provedBeside, type Proved } from "./proved.ts";
import type { Request } from "./request.ts";

/** The states of the open work, one after the other: what is the same is not made again. Runs in the worker. */
export function openWork() {
  const makers = makersAgain();
  let newest: Outcome | null = null;
  /** The run that was sent last, before its proof: it is not made twice. */
  let ahead: Planned | null = null;

  /** The result with what its run took. What stands beside the open work, of no version, is another one each time. */
  function update(request: Request, tell: (stage: Stage) => void = () => undefined): Outcome {
    const begun = stopwatch();
    let pace = 0;
    const stageOf = (stage: Stage) => {
      if (stage === "proving") pace = stopwatch() - begun;
      tell(stage);
    };
    if (request.version === 0) return engine.update(request, stageOf);
    const made = ahead?.version === request.version ? ahead : null;
    newest = engine.update(request, stageOf, made ? { ...makers, planned: () => made } : makers);
    return { ...newest, pace };
  }

  return {
    update,

    /** The run of a request, of which `proved` then sends the proof. */
    planned(request: Request, tell?: (stage: Stage) => void): Planned {
      const begun = stopwatch();
      ahead = makers.planned(request, tell);
      return { ...ahead, pace: stopwatch() - begun };
    },

    /**
     * The proof of a request whose run the page has, without the marks that it has as well when `has` is the version
     * of the last answer.
     */
    proved(request: Request, has: number | null, tell?: (stage: Stage) => void): Proved {
      const before = newest?.version === has ? newest : null;
      return provedBeside(update(request, tell).simulation, before?.simulation.checkpoints ?? []);
    },

    /** The newest outcome: what is asked about it later need not be sent here again. */
    newest: (): Outcome | null => newest,
  };
}
