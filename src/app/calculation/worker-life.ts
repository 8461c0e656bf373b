import { releaseProxy, wrap, type Remote } from "comlink";
import type { Engine } from "./worker.ts";
import { wireOutcomes } from "./wire.ts";

/*
 * The worker that calculates: started when it is first asked, replaced when it has ended. A browser may end one without
 * a word, when the device has no memory left. It holds a lock while it lives; the browser gives that on when it has
 * ended, to the page.
 */

/**
 * A calculation that takes longer has lost its way: the worker is replaced, ms. The longest programs that are simulated
 * take a tenth of that on a desk, and several times as much on a tablet.
 */
const PATIENCE = 120_000;
/** Between two looks whether a new worker has its lock, ms. */
const LOOK_AGAIN = 200;

/** The calculation ended before it had an answer, by no fault of what was asked. */
export class WorkerEnded extends Error {}

/** A worker that does not come is a part of the page that does not come. */
const NOT_FETCHED = "Importing a module script failed: the calculation";

interface Life {
  readonly worker: Worker;
  readonly engine: Remote<Engine>;
  /** Asked when the worker has ended. */
  readonly endings: Set<(why: Error) => void>;
}
let life: Life | null = null;
/** Workers that this page has started. */
let count = 0;

function end(ended: Life, why: Error): void {
  if (life === ended) life = null;
  ended.engine[releaseProxy]();
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
    await new Promise((done) => setTimeout(done, LOOK_AGAIN));
  }
  await locks.request(name, () => life === watched && end(watched, new WorkerEnded("the calculation has ended")));
}

function started(): Life {
  if (life) return life;
  count += 1;
  const name = `turnwise worker ${performance.timeOrigin} ${count}`;
  const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module", name });
  wireOutcomes();
  const begun: Life = { worker, engine: wrap<Engine>(worker), endings: new Set() };
  life = begun;
  const broken = () => end(begun, new WorkerEnded("the calculation broke off"));
  // One that could not be fetched never ran: the browser says no more than that.
  worker.addEventListener("error", (event) =>
    event instanceof ErrorEvent ? broken() : end(begun, new Error(NOT_FETCHED)),
  );
  worker.addEventListener("messageerror", broken);
  void watch(begun, name).catch(() => undefined);
  return begun;
}

/** Ends the worker; the next question starts another one. */
export function stopWorker(): void {
  if (life) end(life, new Error("the calculation was stopped"));
}

/** The answer of the worker, or a failure when the worker ends, or when the answer does not come in time. */
export function askWorker<T>(question: (engine: Remote<Engine>) => Promise<T>): Promise<T> {
  const { engine, endings } = started();
  return new Promise((resolve, reject) => {
    const timer = setTimeout(() => reject(new Error("no answer from the calculation")), PATIENCE);
    endings.add(reject);
    question(engine)
      .then(resolve, reject)
      .finally(() => {
        clearTimeout(timer);
        endings.delete(reject);
      });
  });
}

/** The same, asked once more when the worker ended over it. */
export async function askAgain<T>(question: (engine: Remote<Engine>) => Promise<T>): Promise<T> {
  try {
    return await askWorker(question);
  } catch (error) {
    if (error instanceof WorkerEnded) return await askWorker(question);
    throw error;
  }
}
