import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { cuttingCycles } from "../../cycles/index.ts";
import { exampleJob } from "../../program/job.ts";
import { begin } from "../store.ts";
import { calculateAgain, cancelCalculation, startEngine } from "./client.ts";
import { engine, type Request } from "./engine.ts";
import { useOutcome, type Outcome } from "./outcome.ts";

interface Asked {
  readonly request: Request;
  readonly answer: (outcome: Outcome) => void;
}

/** What the worker was asked and has not answered yet. */
const asked = vi.hoisted(() => [] as Asked[]);
vi.mock("comlink", () => ({
  releaseProxy: Symbol.for("release"),
  transferHandlers: new Map(),
  proxy: (f: unknown) => f,
  wrap: () => ({
    [Symbol.for("release")]: () => undefined,
    update: (request: Request) => new Promise<Outcome>((answer) => asked.push({ request, answer })),
  }),
}));
vi.stubGlobal("Worker", class extends EventTarget {
  terminate() {
    return undefined;
  }
});

const [first, second] = cuttingCycles;
if (!first || !second) throw new Error("the catalogue has no two cycles");

/** The worker answers what it was asked first, however late that is. */
async function answerNext(): Promise<string> {
  await vi.waitFor(() => expect(asked).not.toHaveLength(0));
  const next = asked.shift();
  if (!next) throw new Error("nothing was asked");
  next.answer(engine.update(next.request));
  await new Promise(setImmediate);
  return next.request.text;
}
const shown = () => useOutcome.getState().shown?.text ?? null;

let stop = () => undefined as void;
beforeEach(() => {
  begin(exampleJob(first), "first");
  stop = startEngine();
});
afterEach(async () => {
  begin(null, null);
  while (asked.length > 0) await answerNext();
  stop();
});

test("an answer is shown while its work is open", async () => {
  const text = await answerNext();
  expect(shown()).toBe(text);
});

test("the late answer of a work that was left is not shown under the next one", async () => {
  begin(exampleJob(second), "second");
  const left = await answerNext();
  expect(shown()).toBeNull();
  const next = await answerNext();
  expect(next).not.toBe(left);
  expect(shown()).toBe(next);
});

test("nor that of the same cycle in another work", async () => {
  begin({ ...exampleJob(first), name: "OTHER" }, "other");
  await answerNext();
  expect(shown()).toBeNull();
});

test("nor one that comes when no work is open", async () => {
  begin(null, null);
  await answerNext();
  expect(shown()).toBeNull();
});

test("a calculation that is stopped says so, keeps what is shown, and is done when it is wanted again", async () => {
  await answerNext();
  const before = shown();
  begin(exampleJob(second), "second");
  await vi.waitFor(() => expect(asked).toHaveLength(1));
  cancelCalculation();
  await vi.waitFor(() => expect(useOutcome.getState().stopped).toBe(true));
  await answerNext();
  expect(useOutcome.getState()).toMatchObject({ stopped: true, stage: null, shown: null });
  calculateAgain();
  const text = await answerNext();
  expect(text).not.toBe(before);
  expect(useOutcome.getState()).toMatchObject({ stopped: false, shown: { text } });
});

test("the next work does not wait for a long calculation of the one that was left", async () => {
  await vi.waitFor(() => expect(asked).toHaveLength(1));
  const [long] = asked;
  begin(exampleJob(second), "second");
  await vi.waitFor(() => expect(asked).toHaveLength(2), { timeout: 5000 });
  asked.reverse();
  const text = await answerNext();
  expect(text).not.toBe(long?.request.text);
  expect(shown()).toBe(text);
});

test("of a long program the beginning is shown until the whole is there", async () => {
  const text = `BEGIN PGM LONG MM\nTOOL CALL 1 Z S900 F300\nL X+0 Y+0 Z+2 R0 FMAX\n${
    "L X+1.25 Y+3.5\nL X-2.75 Y+0.5\n".repeat(36_000)
  }END PGM LONG MM\n`;
  begin({ name: "LONG.H", text, encoding: "utf-8" }, "long");
  while (asked.length === 0 || !asked[0]?.request.text.startsWith("BEGIN PGM LONG")) await answerNext();
  const first = await answerNext();
  expect(first.length).toBeLessThan(text.length);
  expect(text.startsWith(first) && first.endsWith("\n")).toBe(true);
  expect(useOutcome.getState()).toMatchObject({ newest: null, dimmed: true, shown: { isBeginning: true } });
  expect(await answerNext()).toBe(text);
  expect(useOutcome.getState()).toMatchObject({ dimmed: false, shown: { text } });
});
