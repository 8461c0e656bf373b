import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { isMissing } from "../base/parts.ts";
import { askAgain, askWorker, stopWorker, WorkerEnded } from "./worker-life.ts";

interface Answering {
  readonly answer: (value: string) => void;
}
const asked = vi.hoisted(() => [] as Answering[]);
vi.mock("comlink", () => ({
  releaseProxy: Symbol.for("release"),
  transferHandlers: new Map(),
  wrap: () => ({
    [Symbol.for("release")]: () => undefined,
    update: () => new Promise<string>((answer) => asked.push({ answer })),
  }),
}));

class FakeWorker extends EventTarget {
  readonly name: string;
  ended = false;
  constructor(_: URL, { name }: { readonly name: string }) {
    super();
    this.name = name;
    workers.push(this);
  }
  terminate() {
    this.ended = true;
  }
}
let workers: FakeWorker[] = [];
/** Who waits for the lock that a worker holds. */
const locks = new Map<string, () => void>();
const fakeLocks = {
  query: () => Promise.resolve({ held: workers.filter((w) => !w.ended).map(({ name }) => ({ name })) }),
  request: (name: string, then: () => void) => new Promise<void>((done) => locks.set(name, () => done(then()))),
};
beforeEach(() => {
  vi.stubGlobal("Worker", FakeWorker);
  Object.defineProperty(navigator, "locks", { value: fakeLocks, configurable: true });
  workers = [];
  asked.length = 0;
  locks.clear();
});
afterEach(() => {
  stopWorker();
  vi.unstubAllGlobals();
});

const question = (ask: typeof askAgain) =>
  ask((engine) => (engine as unknown as { update: () => Promise<string> }).update());
/** The browser takes a worker away without a word. */
async function kill(worker: FakeWorker | undefined): Promise<void> {
  await vi.waitFor(() => expect(locks.has(worker?.name ?? "")).toBe(true));
  if (worker) worker.ended = true;
  locks.get(worker?.name ?? "")?.();
}

test("a worker that is taken away without a word is replaced, and asked the same once more", async () => {
  const answer = question(askAgain);
  expect(workers).toHaveLength(1);
  await kill(workers[0]);
  await vi.waitFor(() => expect(asked).toHaveLength(2));
  expect(workers).toHaveLength(2);
  expect(workers[1]?.name).not.toBe(workers[0]?.name);
  asked[1]?.answer("the second");
  expect(await answer).toBe("the second");
});

test("one that ends again over the same question is not asked a third time", async () => {
  const answer = question(askAgain);
  const refused = expect(answer).rejects.toBeInstanceOf(WorkerEnded);
  await kill(workers[0]);
  await vi.waitFor(() => expect(workers).toHaveLength(2));
  workers[1]?.dispatchEvent(new ErrorEvent("error"));
  await refused;
  expect(workers).toHaveLength(2);
});

test("taken away while it rests, it is another one that is asked next", async () => {
  const first = question(askWorker);
  asked[0]?.answer("a");
  expect(await first).toBe("a");
  await kill(workers[0]);
  const second = question(askWorker);
  expect(workers).toHaveLength(2);
  asked[1]?.answer("b");
  expect(await second).toBe("b");
});

test("one that could not be fetched is a missing part of the page", async () => {
  const answer = question(askAgain);
  const refused = answer.catch((error: unknown) => error);
  workers[0]?.dispatchEvent(new Event("error"));
  expect(isMissing(await refused)).toBe(true);
  expect(workers).toHaveLength(1);
});

test("stopped by the page, it is not asked again", async () => {
  const answer = question(askAgain);
  const refused = expect(answer).rejects.not.toBeInstanceOf(WorkerEnded);
  stopWorker();
  await refused;
  expect(workers).toHaveLength(1);
  expect(workers[0]?.ended).toBe(true);
});
