import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { cuttingCycles } from "../../cycles/index.ts";
import { exampleJob } from "../../program/job/job.ts";
import { begin, edit } from "../document/store.ts";
import { calculateAgain, cancelCalculation, startEngine } from "./client.ts";
import { engine } from "./engine.ts";
import type { Request } from "./request.ts";
import { useOutcome, type Outcome } from "./outcome.ts";

interface Asked {
  readonly request: Request;
  /** Answers with what was asked for: all of it, the proof of a run that the page has, or the run alone. */
  readonly answer: (outcome: Outcome) => void;
  readonly what: "update" | "proved" | "planned";
}

/** Whether the page plans by itself, takes long for it, and has that done by the worker. */
const page = vi.hoisted(() => ({ plans: false, isSlow: false, isByBits: false, isLong: false }));
vi.mock("./page-plan.ts", async () => {
  const { planned } = await import("./plan.ts");
  return {
    fetchPlan: () => () => undefined,
    forgetPace: () => undefined,
    notePace: () => undefined,
    planNow: (request: Request) => (page.plans ? planned(request) : null),
    planSoon: (request: Request, done: (made: ReturnType<typeof planned>) => void) => {
      if (!page.isByBits) return null;
      const timer = setTimeout(() => done(planned(request)), 20);
      return () => clearTimeout(timer);
    },
    plansBehindDigit: () => page.isSlow,
    plansLong: () => page.isLong,
  };
});

/** What the worker was asked and has not answered yet. */
const asked = vi.hoisted(() => [] as Asked[]);
vi.mock("comlink", () => ({
  releaseProxy: Symbol.for("release"),
  transferHandlers: new Map(),
  proxy: (f: unknown) => f,
  wrap: () => ({
    [Symbol.for("release")]: () => undefined,
    update: (request: Request) => new Promise<Outcome>((answer) => asked.push({ request, answer, what: "update" })),
    planned: (request: Request) =>
      new Promise((answer) =>
        asked.push({ request, answer: (made) => answer({ ...made, simulation: null }), what: "planned" }),
      ),
    proved: (request: Request) =>
      new Promise((answer) =>
        asked.push({
          request,
          answer: ({ simulation: { blank: _, steps: __, ...rest } }) => answer({ ...rest, kept: 0 }),
          what: "proved",
        }),
      ),
  }),
}));
vi.stubGlobal(
  "Worker",
  class extends EventTarget {
    terminate() {
      return undefined;
    }
  },
);

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
  Object.assign(page, { plans: false, isSlow: false, isByBits: false, isLong: false });
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
  const text = `BEGIN PGM LONG MM\nTOOL CALL 1 Z S900 F300\nL X+0 Y+0 Z+2 R0 FMAX\n${"L X+1.25 Y+3.5\nL X-2.75 Y+0.5\n".repeat(
    36_000,
  )}END PGM LONG MM\n`;
  begin({ name: "LONG.H", text, encoding: "utf-8" }, "long");
  while (asked.length === 0 || !asked[0]?.request.text.startsWith("BEGIN PGM LONG")) await answerNext();
  const first = await answerNext();
  expect(first.length).toBeLessThan(text.length);
  expect(text.startsWith(first) && first.endsWith("\n")).toBe(true);
  expect(useOutcome.getState()).toMatchObject({ newest: null, dimmed: true, shown: { isBeginning: true } });
  expect(await answerNext()).toBe(text);
  expect(useOutcome.getState()).toMatchObject({ dimmed: false, shown: { text } });
});

const typeInto = (draft: Readonly<Record<string, string>>) =>
  edit((job) => ({ ...job, drafts: { ...job.drafts, [job.cycle]: { ...job.drafts[job.cycle], ...draft } } }));

test("what the page plans is in the picture before anything is asked, and its proof comes with the very same run", async () => {
  const before = await answerNext();
  page.plans = true;
  typeInto({ Q483: "0.37" });
  const { newest, shown: proved, planned, pictured, dimmed, stage } = useOutcome.getState();
  expect([newest?.text, proved?.text]).toEqual([before, before]);
  expect(pictured).toBe(planned);
  expect(pictured).toMatchObject({ simulation: null });
  expect(pictured?.text).toContain("Q483=+0.37");
  expect([dimmed, stage]).toEqual([false, "reading"]);

  await vi.waitFor(() => expect(asked).toHaveLength(1));
  const [{ request, what } = { request: null, what: null }] = asked;
  expect(what).toBe("proved");
  await answerNext();
  const now = useOutcome.getState();
  expect(now.planned).toBeNull();
  expect(now.pictured).toBe(now.newest);
  expect(now.newest?.run).toBe(pictured?.run);
  const { pace: _, ...whole } = now.newest as Outcome;
  expect(whole).toEqual(request && engine.update(request));
});

/** Both ways in which the page plans what takes it long. */
const LATER = [
  { way: "slowly", isSlow: true, isByBits: false },
  { way: "bit by bit", isSlow: false, isByBits: true },
];

test.each(LATER)(
  "what the page plans $way is planned behind the picture of the digit, and of several digits the last",
  async (how) => {
    await answerNext();
    Object.assign(page, { plans: true }, how);
    const before = useOutcome.getState().pictured;
    for (const Q483 of ["0.3", "0.37", "0.371"]) typeInto({ Q483 });
    expect(useOutcome.getState()).toMatchObject({ pictured: before, stage: "reading" });
    const seen: (string | undefined)[] = [];
    const stop = useOutcome.atOnce.subscribe(
      ({ planned }) => void seen.push(/Q483=\S+/.exec(planned?.text ?? "")?.[0]),
    );
    await vi.waitFor(() => expect(asked).toHaveLength(1));
    stop();
    expect([...new Set(seen)].filter((each) => each !== undefined)).toEqual(["Q483=+0.371"]);
    expect(useOutcome.getState().planned?.text).toContain("Q483=+0.371");
  },
);

test.each(LATER)(
  "what is planned $way and not yet is forgotten with its work, and planned when emptied values come again",
  async (how) => {
    await answerNext();
    Object.assign(page, { plans: true }, how);
    typeInto({ Q483: "0.37" });
    typeInto({ Q483: "" });
    expect(useOutcome.getState().paused).toBe(true);
    typeInto({ Q483: "0.37" });
    await vi.waitFor(() => expect(useOutcome.getState().planned?.text).toContain("Q483=+0.37"));
    await answerNext();
    typeInto({ Q483: "0.38" });
    begin(exampleJob(second), "other");
    await new Promise((done) => setTimeout(done, 60));
    expect(useOutcome.getState().planned?.text ?? "").not.toContain("Q483=+0.38");
  },
);

test("a proof that comes when more was typed leaves the newer path in the picture", async () => {
  await answerNext();
  page.plans = true;
  typeInto({ Q483: "0.37" });
  await vi.waitFor(() => expect(asked).toHaveLength(1));
  typeInto({ Q483: "0.38" });
  const first = await answerNext();
  expect(first).toContain("Q483=+0.37");
  const { newest, planned, pictured } = useOutcome.getState();
  expect(newest?.text).toBe(first);
  expect(pictured).toBe(planned);
  expect(pictured?.text).toContain("Q483=+0.38");
  await answerNext();
  expect(useOutcome.getState()).toMatchObject({ planned: null, dimmed: false });
  expect(shown()).toBe(pictured?.text);
});

test("values that were emptied before they were proved are proved when they come again", async () => {
  await answerNext();
  page.plans = true;
  typeInto({ Q483: "0.37" });
  await vi.waitFor(() => expect(asked).toHaveLength(1));
  typeInto({ Q483: "0.38" });
  typeInto({ Q483: "" });
  expect(useOutcome.getState()).toMatchObject({ paused: true, dimmed: true });
  await answerNext();
  typeInto({ Q483: "0.38" });
  const proved = await answerNext();
  expect(proved).toContain("Q483=+0.38");
  expect(useOutcome.getState()).toMatchObject({ planned: null, dimmed: false });
  expect(shown()).toBe(proved);
});

test("what takes long to prove is planned by the worker, and seen before that", async () => {
  page.isLong = true;
  begin(exampleJob(second), "second");
  await vi.waitFor(() => expect(asked.map(({ what }) => what)).toContain("planned"));
  while (asked[0]?.what !== "planned") await answerNext();
  const text = await answerNext();
  const { newest, planned, pictured, dimmed, stage } = useOutcome.getState();
  expect([newest, pictured, dimmed]).toEqual([null, planned, false]);
  expect([planned?.text, planned?.simulation, stage === null]).toEqual([text, null, false]);
  expect(asked.map(({ what }) => what)).toEqual(["proved"]);
  await answerNext();
  const now = useOutcome.getState();
  expect([now.planned, now.newest?.run, now.stage]).toEqual([null, planned?.run, null]);
});

test("what is typed while something long is planned is planned next, and only that is proved", async () => {
  await answerNext();
  page.isLong = true;
  typeInto({ Q483: "0.37" });
  await vi.waitFor(() => expect(asked).toHaveLength(1));
  typeInto({ Q483: "0.371" });
  await answerNext();
  expect(useOutcome.getState().pictured?.text).toContain("Q483=+0.37 ");
  await vi.waitFor(() => expect(asked.map(({ what }) => what)).toEqual(["planned"]));
  await answerNext();
  expect(useOutcome.getState().pictured?.text).toContain("Q483=+0.371 ");
  expect(asked.map(({ what }) => what)).toEqual(["proved"]);
  await answerNext();
  expect(useOutcome.getState()).toMatchObject({ planned: null, dimmed: false });
  expect(shown()).toContain("Q483=+0.371 ");
});
