import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { isMissing } from "../base/parts.ts";
import { CALCULATING } from "../base/waits.ts";
import { WorkerEnded, workerLife } from "./worker-life.ts";

/** Questions that the workers have not answered yet. */
const asked: { readonly answer: (value: string) => void }[] = [];

class FakeWorker extends EventTarget {
  ended = false;
  readonly engine = { update: () => new Promise<string>((answer) => asked.push({ answer })) };
  constructor(readonly name: string) {
    super();
  }
  terminate() {
    this.ended = true;
  }
}
let workers: FakeWorker[] = [];
let life: ReturnType<typeof workerLife<FakeWorker["engine"]>>;
/** Callbacks that wait for the lock of a worker. */
const locks = new Map<string, () => void>();
const fakeLocks = {
  query: () => Promise.resolve({ held: workers.filter((w) => !w.ended).map(({ name }) => ({ name })) }),
  request: (name: string, then: () => void) => new Promise<void>((done) => locks.set(name, () => done(then()))),
};
beforeEach(() => {
  Object.defineProperty(navigator, "locks", { value: fakeLocks, configurable: true });
  workers = [];
  asked.length = 0;
  locks.clear();
  life = workerLife((name) => {
    const worker = new FakeWorker(name);
    workers.push(worker);
    return { worker, engine: worker.engine, release: () => undefined };
  });
});
afterEach(() => life.stop());

const question = (ask: typeof life.ask) => ask((engine) => engine.update());
/** The browser ends a worker without an event. */
async function kill(worker: FakeWorker | undefined): Promise<void> {
  await vi.waitFor(() => expect(locks.has(worker?.name ?? "")).toBe(true));
  if (worker) worker.ended = true;
  locks.get(worker?.name ?? "")?.();
}

test("a worker that ends without an event is replaced, and the question repeated once", async () => {
  const answer = question(life.askAgain);
  expect(workers).toHaveLength(1);
  await kill(workers[0]);
  await vi.waitFor(() => expect(asked).toHaveLength(2));
  expect(workers).toHaveLength(2);
  expect(workers[1]?.name).not.toBe(workers[0]?.name);
  asked[1]?.answer("the second");
  expect(await answer).toBe("the second");
});

test("a worker that ends again over the same question is not asked a third time", async () => {
  const answer = question(life.askAgain);
  const refused = expect(answer).rejects.toBeInstanceOf(WorkerEnded);
  await kill(workers[0]);
  await vi.waitFor(() => expect(workers).toHaveLength(2));
  workers[1]?.dispatchEvent(new ErrorEvent("error"));
  await refused;
  expect(workers).toHaveLength(2);
});

test("after a worker ends while idle, the next question goes to a new one", async () => {
  const first = question(life.ask);
  asked[0]?.answer("a");
  expect(await first).toBe("a");
  await kill(workers[0]);
  const second = question(life.ask);
  expect(workers).toHaveLength(2);
  asked[1]?.answer("b");
  expect(await second).toBe("b");
});

test("a worker that could not be fetched is a missing part of the page", async () => {
  const answer = question(life.askAgain);
  const refused = answer.catch((error: unknown) => error);
  workers[0]?.dispatchEvent(new Event("error"));
  expect(isMissing(await refused)).toBe(true);
  expect(workers).toHaveLength(1);
});

test("after a stop by the page the question is not repeated", async () => {
  const answer = question(life.askAgain);
  const refused = expect(answer).rejects.not.toBeInstanceOf(WorkerEnded);
  life.stop();
  await refused;
  expect(workers).toHaveLength(1);
  expect(workers[0]?.ended).toBe(true);
});

test("a worker that gets on is waited for, one that does not is given up", async () => {
  vi.useFakeTimers();
  try {
    let alive = () => undefined as void;
    const answer = life.ask((engine, gotOn) => {
      alive = gotOn;
      return engine.update();
    });
    let ended = false;
    const given = expect(answer.finally(() => (ended = true))).rejects.toThrow("no answer");
    for (let i = 0; i < 5; i += 1) {
      await vi.advanceTimersByTimeAsync(0.9 * CALCULATING.answer);
      alive();
    }
    expect(ended).toBe(false);
    vi.advanceTimersByTime(1.1 * CALCULATING.answer);
    await given;
  } finally {
    vi.useRealTimers();
  }
});

test("a sign that comes after the answer waits for nothing: the question is forgotten", async () => {
  vi.useFakeTimers();
  try {
    let sign: () => void = () => undefined;
    const answer = life.ask((engine, alive) => {
      sign = alive;
      return engine.update();
    });
    // One for the answer, and one until the lock of the worker is looked for again.
    const waiting = vi.getTimerCount();
    asked[0]?.answer("a");
    expect(await answer).toBe("a");
    await vi.advanceTimersByTimeAsync(0);
    const idle = vi.getTimerCount();
    sign();
    expect([vi.getTimerCount(), idle < waiting]).toEqual([idle, true]);
  } finally {
    vi.useRealTimers();
  }
});
