import type { Remote } from "comlink";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { cuttingCycles } from "../../cycles/index.ts";
import { exampleJob } from "../../program/job/job.ts";
import { useSettings } from "../base/settings/settings.ts";
import { openFirstWork, changeJob } from "../document/store.ts";
import { createCalculation } from "./calculation.ts";
import type { Wait } from "./calculation-state.ts";
import { engine } from "./engine.ts";
import { openWork } from "./open-work.ts";
import { useOutcome, type Outcome } from "./outcome.ts";
import { pageExecutor } from "./page-executor.ts";
import type { Request } from "./request.ts";
import { workerExecutor } from "./worker-executor.ts";
import type { Engine } from "./worker.ts";

/** Waits for a condition, also on a slow machine. */
const until = (holds: () => void) => vi.waitFor(holds, { timeout: 20_000 });

/** The stopwatch stands still: the speed of this machine decides nothing here. */
vi.mock(import("../base/clock.ts"), async (original) => ({ ...(await original()), stopwatch: () => 8.5 }));

const [first, second] = cuttingCycles;
if (!first || !second) throw new Error("the catalogue has no two cycles");

/** The code of the worker on the page: it answers when the test says so. */
function worker() {
  const { update, planned, proved } = openWork();
  const asked: { readonly what: string; readonly request: Request; readonly answer: () => void }[] = [];
  const later =
    <T,>(what: string, make: (request: Request, ...more: never[]) => T) =>
    (request: Request, ...more: never[]) =>
      new Promise<T>((done) => asked.push({ what, request, answer: () => done(make(request, ...more)) }));
  const served = {
    update: later("update", update),
    planned: later("planned", planned),
    proved: later("proved", proved),
  };
  return {
    asked,
    execute: workerExecutor((question) => question(served as unknown as Remote<Engine>, () => undefined)),
    /** Answers the oldest question. */
    async answer(): Promise<Request> {
      await until(() => expect(asked).not.toHaveLength(0));
      const next = asked.shift();
      next?.answer();
      await new Promise(setImmediate);
      return next?.request ?? Promise.reject(new Error("nothing was asked"));
    },
  };
}

/** A calculation with the real code of page and worker, controlled by the test. */
function started() {
  const page = pageExecutor();
  const served = worker();
  const waits = new Map<Wait, () => void>();
  const stopWorker = vi.fn();
  const calculation = createCalculation({
    page: page.execute,
    worker: served.execute,
    stopWorker,
    wait(wait, _, then) {
      waits.set(wait, then);
      return () => void waits.delete(wait);
    },
  });
  const rest = (wait: Wait) => {
    const then = waits.get(wait);
    waits.delete(wait);
    then?.();
  };
  return { ...served, calculation, page, rest, waits, stopWorker, stop: calculation.start() };
}

let it: ReturnType<typeof started>;
beforeEach(() => {
  openFirstWork(exampleJob(first), "first");
  it = started();
});
afterEach(() => {
  openFirstWork(null, null);
  it.stop();
});

const shown = () => useOutcome.getState().shown?.text ?? null;
const typeInto = (draft: Readonly<Record<string, string>>) =>
  changeJob((job) => ({ ...job, drafts: { ...job.drafts, [job.cycle]: { ...job.drafts[job.cycle], ...draft } } }));
/** Lets the page plan. */
async function plansHere(): Promise<void> {
  await it.page.fetch();
  it.rest("planner");
}

test("a work is calculated when it is opened, and shown while it is open", async () => {
  const { text } = await it.answer();
  expect(shown()).toBe(text);
  openFirstWork(exampleJob(second), "second");
  expect(shown()).toBeNull();
  expect((await it.answer()).text).not.toBe(text);
  openFirstWork(null, null);
  expect([shown(), it.asked]).toEqual([null, []]);
});

test("another work of the same cycle is calculated anew", async () => {
  openFirstWork({ ...exampleJob(first), name: "OTHER" }, "other");
  await it.answer();
  expect(shown()).toBeNull();
  const { text } = await it.answer();
  expect([shown(), text.includes("OTHER")]).toEqual([text, true]);
});

test("a change that leaves the program the same is not calculated", async () => {
  await it.answer();
  useSettings.setState({ programFolded: true });
  changeJob((job) => ({ ...job, remarks: "turned twice" }));
  expect(it.asked).toEqual([]);
});

test("a path planned on the page is shown in the task of the key, and its check comes with the very same run", async () => {
  const { text } = await it.answer();
  await plansHere();
  typeInto({ Q483: "0.37" });
  const { newest, planned, pictured, dimmed, stage } = useOutcome.getState();
  expect([newest?.text, pictured === planned, dimmed, stage]).toEqual([text, true, false, "reading"]);
  expect(pictured?.text).toContain("Q483=+0.37");
  expect(it.asked).toEqual([]);
  it.rest("picture");
  await until(() => expect(it.asked.map(({ what }) => what)).toEqual(["proved"]));
  const request = await it.answer();
  const now = useOutcome.getState();
  expect([now.planned, now.pictured === now.newest, now.newest?.run === pictured?.run]).toEqual([null, true, true]);
  const { pace: _, ...whole } = now.newest as Outcome;
  expect(whole).toEqual(engine.update(request));
});

test("while values are incomplete the last picture stays, dimmed, until they are complete again", async () => {
  const { text } = await it.answer();
  typeInto({ Q483: "" });
  expect(useOutcome.getState()).toMatchObject({ paused: true, dimmed: true, stage: null });
  expect(shown()).toBe(text);
  typeInto({ Q483: "0.38" });
  expect((await it.answer()).text).toContain("Q483=+0.38");
  expect(useOutcome.getState()).toMatchObject({ paused: false, dimmed: false });
});

test("stopped by the operator, it says so and continues on request", async () => {
  await until(() => expect(it.asked).toHaveLength(1));
  it.calculation.cancel();
  expect(it.stopWorker).toHaveBeenCalledOnce();
  await it.answer();
  expect(useOutcome.getState()).toMatchObject({ stopped: true, stage: null, shown: null });
  it.calculation.again();
  const { text } = await it.answer();
  expect(useOutcome.getState()).toMatchObject({ stopped: false, shown: { text } });
});

test("a result waits while somebody types in a text", async () => {
  await until(() => expect(it.asked).toHaveLength(1));
  it.calculation.typed(150);
  const { text } = await it.answer();
  expect(shown()).toBeNull();
  it.rest("quiet");
  expect(shown()).toBe(text);
});

test("the run of a task that asks first is hidden, and recalculated when it may be seen", async () => {
  openFirstWork({ ...exampleJob(first), task: { id: "how-many", veiled: true } }, "task");
  await it.answer();
  await it.answer();
  await until(() => expect(shown()).toContain("BEGIN PGM"));
  const steps = () => useOutcome.getState().newest?.run.steps.length ?? 0;
  expect(steps()).toBe(0);
  await plansHere();
  typeInto({ Q483: "0.37" });
  expect(useOutcome.getState().planned).toBeNull();
  await it.answer();
  expect(steps()).toBe(0);
  changeJob((job) => ({ ...job, task: { id: "how-many" } }));
  it.calculation.recalculate();
  expect(useOutcome.getState().pictured?.run.steps.length).toBeGreaterThan(3);
});

test("a long program shows its beginning first, then its path, then its check", async () => {
  const cut = "L X+1.25 Y+3.5\nL X-2.75 Y+0.5\n";
  const text = `BEGIN PGM LONG MM\nTOOL CALL 1 Z S900 F300\nL X+0 Y+0 Z+2 R0 FMAX\n${cut.repeat(36_000)}END PGM LONG MM\n`;
  openFirstWork({ name: "LONG.H", text, encoding: "utf-8" }, "long");
  await it.answer();
  const beginning = await it.answer();
  expect(text.startsWith(beginning.text) && beginning.text.endsWith("\n")).toBe(true);
  expect(useOutcome.getState()).toMatchObject({ newest: null, dimmed: true, shown: { isBeginning: true } });
  await until(() => expect(it.asked.map(({ what }) => what)).toEqual(["planned"]));
  await it.answer();
  const { planned, pictured } = useOutcome.getState();
  expect([planned?.text, pictured === planned]).toEqual([text, true]);
  await it.answer();
  expect(useOutcome.getState().newest?.run).toBe(planned?.run);
});
