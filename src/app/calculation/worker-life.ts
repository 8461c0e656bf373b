import { releaseProxy, wrap, type Remote } from "comlink";
import { CALCULATING } from "../base/waits.ts";
import type { Engine } from "./worker.ts";
import { wireOutcomes } from "./wire.ts";

/*
 * The calculation worker: started on first use, replaced after it has ended. A browser may end it without an event when
 * memory is short. The worker holds a lock while it lives; the page gets the lock when the worker has ended.
 */

/** The worker ended before it had an answer, not because of the question. */
export class WorkerEnded extends Error {}

/** A worker that cannot be fetched counts as a missing part of the page. */
const NOT_FETCHED = "Importing a module script failed: the calculation";

/** A worker, and its proxy. */
interface Started<E> {
  readonly worker: Pick<Worker, "addEventListener" | "terminate">;
  readonly engine: E;
  readonly release: () => void;
}

/** Asks the worker; `alive` is called with each sign that it gets on. */
type Question<E, T> = (engine: E, alive: () => void) => Promise<T>;

/** Runs one worker at a time. `start` makes one with a name. */
export function workerLife<E>(start: (name: string) => Started<E>) {
  interface Life extends Started<E> {
    /** Called when the worker has ended. */
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

  /** Waits for the lock of a worker, once the worker holds it: the page gets the lock when the worker has ended. */
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
    // A worker that could not be fetched gives a plain Event without a message.
    begun.worker.addEventListener("error", (event) =>
      event instanceof ErrorEvent ? broken() : end(begun, new Error(NOT_FETCHED)),
    );
    begun.worker.addEventListener("messageerror", broken);
    void watch(begun, name).catch(() => undefined);
    return begun;
  }

  function ask<T>(question: Question<E, T>): Promise<T> {
    const { engine, endings } = started();
    return new Promise((resolve, reject) => {
      let timer: ReturnType<typeof setTimeout> | undefined;
      // A sign may come later than the answer: it has a channel of its own.
      const wait = () => {
        if (!endings.has(reject)) return;
        clearTimeout(timer);
        timer = setTimeout(() => reject(new Error("no answer from the calculation")), CALCULATING.answer);
      };
      endings.add(reject);
      wait();
      question(engine, wait)
        .then(resolve, reject)
        .finally(() => {
          clearTimeout(timer);
          endings.delete(reject);
        });
    });
  }

  return {
    /** The answer of the worker; fails if the worker ends, or if it neither answers nor gets on for too long. */
    ask,
    /** The same, repeated once if the worker ended. */
    async askAgain<T>(question: Question<E, T>): Promise<T> {
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
