import { proxy } from "comlink";
import { retryImport } from "../base/parts.ts";
import { sourceFields, type Executor, type Order } from "./orders.ts";
import type { AtStage, Outcome } from "./outcome.ts";
import { simulationOf } from "./proof-delta.ts";
import type { askAgain } from "./worker-life.ts";

/** Tells a stage, which also shows that the worker gets on. */
const heard =
  (tell: AtStage, alive: () => void): AtStage =>
  (...stage) => {
    alive();
    tell(...stage);
  };

/**
 * Plans and checks in the worker. A run that the page has planned is not sent there: copying it costs both sides more
 * than planning it again from the previous one (docs/performance.md).
 */
export function workerExecutor(ask: typeof askAgain): Executor {
  /** The last answer: its checkpoints are not sent again. */
  let answered: Pick<Outcome, "version" | "simulation"> | null = null;

  async function outcomeOf({ request, planned }: Order & { do: "prove" }, tell: AtStage) {
    const made = await ask(async (engine, alive): Promise<Outcome> => {
      const atStage = proxy(heard(tell, alive));
      if (!planned) return { ...(await engine.update(request, atStage)), ...sourceFields(request) };
      const proof = await engine.proved(request, answered?.version ?? null, atStage);
      return { ...planned, simulation: simulationOf(proof, planned.run, answered) };
    });
    answered = made;
    return made;
  }

  return (order, tell) => {
    const { version } = order.request;
    const began: AtStage = (stage, share = 0) => tell({ event: "began", version, stage, share });
    const done = async () => {
      if (order.do === "plan") {
        const made = await retryImport(() =>
          ask((engine, alive) => engine.planned(order.request, proxy(heard(began, alive)))),
        );
        tell({ event: "planned", version, made: { ...made, ...sourceFields(order.request) }, took: made.pace ?? 0 });
      } else {
        const made = await retryImport(() => outcomeOf(order, began));
        const outcome = order.isVeiled ? (await retryImport(() => import("./veil.ts"))).veil(made) : made;
        tell({ event: "proved", version, outcome });
      }
    };
    done().catch(() => tell({ event: "failed", version }));
  };
}
