import { releaseProxy, wrap, type Remote } from "comlink";
import { CALCULATING } from "../base/waits.ts";
import type { Engine } from "./worker.ts";
import { wireOutcomes } from "./wire.ts";

/*
 * The worker that calculates: started when it is first asked, replaced when it has ended. A browser may end one without
 * a word, when the device has no memory left. It holds a lock while it lives; the browser gives that on when it has
 * ended, to the page.
 */

/** The calculation ended before it had an answer, by no fault of what was asked. */
export class WorkerEnded extends Error {}

/** A worker that does not come is a part of the page that does not come. */
const NOT_FETCHED = "Importing a module script failed: the calculation";

/** A worker, and how it is asked. */
interface Started<E> {
  readonly worker: Pick<Worker, "addEventListener" | "terminate">;
  readonly engine: E;
  readonly release: () => void;
}

/** One worker after the other. `start` makes one with a name. */
export function workerLife<E>(start: (name: string) => Started<E>) {
  interface Life extends Started<E> {
    /** Asked when the worker has ended. */
    readonly endings: Set<(why: Error) => void>;
  }
  let life: Life | null = null;
  let count = 0;

  function end(ended: Life, why: Error): void {
    if (life === ended) life = null;
    ended.release();
    ended.worker.terminate();
    for (const tell of ended.endings) tell(why);
  }

  /** Waits for the lock of a worker, from the moment when the worker has it: it comes when the worker has ended. */
  async function watch(watched: Life, name: string): Promise<void> {
    const locks = typeof navigator === "undefined" ? undefined : navigator.locks;
    if (!locks) return;
    for (;;) {
      const { held = [] } = await locks.query();
      if (life !== watched) return;
      if (held.some((lock) => lock.name === name)) break;
      await new Promise((done) => setTimeout(done, CALCULATING.lock));
    }
    await locks.request(name, () => life === watched && end(watched, new WorkerEnded("the calculation has ended")));
  }

  function started(): Life {
    if (life) return life;
    count += 1;
    const name = `turnwise worker ${performance.timeOrigin} ${count}`;
    const begun: Life = { ...start(name), endings: new Set() };
    life = begun;
    const broken = () => end(begun, new WorkerEnded("the calculation broke off"));
    // One that could not be fetched never ran: the browser says no more than that.
    begun.worker.addEventListener("error", (event) =>
      event instanceof ErrorEvent ? broken() : end(begun, new Error(NOT_FETCHED)),
    );
    begun.worker.addEventListener("messageerror", broken);
    void watch(begun, name).catch(() => undefined);
    return begun;
  }

  function ask<T>(question: (engine: E) => Promise<T>): Promise<T> {
    const { engine, endings } = started();
    return new Promise((resolve, reject) => {
      const timer = setTimeout(() => reject(new Error("no answer from the calculation")), CALCULATING.answer);
      endings.add(reject);
      question(engine)
        .then(resolve, reject)
        .finally(() => {
          clearTimeout(timer);
          endings.delete(reject);
        });
    });
  }

  return {
    /** The answer of the worker, or a failure when the worker ends, or when the answer does not come in time. */
    ask,
    /** The same, asked once more when the worker ended over it. */
    async askAgain<T>(question: (engine: E) => Promise<T>): Promise<T> {
      try {
        return await ask(question);
      } catch (error) {
        if (error instanceof WorkerEnded) return await ask(question);
        throw error;
      }
    },
    /** Ends the worker; the next question starts another one. */
    stop(): void {
      if (life) end(life, new Error("the calculation was stopped"));
    },
  };
}

/** The worker of this page. */
export const {
  ask: askWorker,
  askAgain,
  stop: stopWorker,
} = workerLife<Remote<Engine>>((name) => {
  const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module", name });
  wireOutcomes();
  const engine = wrap<Engine>(worker);
  return { worker, engine, release: () => engine[releaseProxy]() };
});
