import { beforeEach, expect, test, vi } from "vitest";
import {
  fetchPlan,
  forgetPace,
  notePace,
  planNow,
  planSoon,
  plansBehindDigit,
  plansLong,
  plansOnPage,
  whenRehearsed,
} from "./page-plan.ts";
import type { Request } from "./request.ts";

/** What the next run takes, ms, and whether it comes to nothing. */
const run = vi.hoisted(() => ({ takes: 0, fails: false, now: 0, rehearsed: [] as string[], bits: 0, rests: true }));
vi.mock("../base/clock.ts", () => ({ stopwatch: () => run.now }));
vi.mock("../base/rest.ts", () => ({
  atRest: (begin: () => void) => {
    if (run.rests) begin();
    return () => undefined;
  },
}));
vi.mock("./plan.ts", () => ({
  planned: ({ text }: Request) => {
    run.rehearsed.push(text);
    run.now += run.takes;
  },
  planner: () =>
    Object.assign(
      ({ version, text }: Request) => {
        run.now += run.takes;
        if (run.fails) throw new Error("a fault of our own");
        return { version, text, run: {}, simulation: null };
      },
      {
        part: ({ version, text }: Request, goesOn: () => boolean) => {
          run.bits += 1;
          do run.now += 2.3;
          while (goesOn());
          return run.bits < 7 ? null : { version, text, run: {}, simulation: null };
        },
      },
    ),
}));

const requestOf = (text: string, beside = 0): Request => ({
  version: 7,
  text,
  files: beside > 0 ? [{ name: "B.H", text: "L".repeat(beside) }] : [],
  table: { tools: [], mills: [], refused: new Map() },
  rapid: 9300,
  control: "TNC7",
});
const plans = (text = "L X+3.5") => planNow(requestOf(text)) !== null;

beforeEach(async () => {
  Object.assign(run, { takes: 1.3, fails: false, now: 0, rehearsed: [], bits: 0, rests: true });
  forgetPace();
  fetchPlan();
  await vi.waitFor(() => expect(plansOnPage(17)).toBe(true));
});

test("a short text is planned at once, a long one not before it is known to be quick", () => {
  expect(planNow(requestOf("L X+3.5"))).toMatchObject({ version: 7, text: "L X+3.5" });
  forgetPace();
  expect(plans("L".repeat(20_001))).toBe(false);
  expect(planNow(requestOf("L X+3.5", 20_000))).toBeNull();
  notePace(requestOf("L".repeat(20_001)), 59.6);
  expect(plans("L".repeat(20_001))).toBe(true);
});

test("a digit is drawn before its path where planning has taken long twice, also with quick runs between", () => {
  const plansIn = (takes: number) => {
    run.takes = takes;
    plans();
    return plansBehindDigit();
  };
  expect([3.2, 61.1, 2.9, 60.7, 2.8, 3.1].map(plansIn)).toEqual([false, false, false, true, true, false]);
  forgetPace();
  expect([3.1, 180.5, 2.6, 59.9].map(plansIn)).toEqual([false, false, false, false]);
});

test("what takes longer is left to the worker, until it takes less there", () => {
  run.takes = 63.7;
  expect([plans(), plans()]).toEqual([true, false]);
  notePace(requestOf("L X+3.5"), undefined);
  expect(plans()).toBe(false);
  notePace(requestOf("L X+3.5"), 4.9);
  expect(plans()).toBe(true);
});

test("a run that had to wait once is no slow run; three of them are", () => {
  expect(plans()).toBe(true);
  run.takes = 61.2;
  expect([plans(), plans(), plans(), plans()]).toEqual([true, true, true, false]);
});

test("a plan that fails is left to the worker, which says so", () => {
  run.fails = true;
  expect(plans()).toBe(false);
  expect(plansOnPage(17)).toBe(true);
});

test("an opened work is planned by and by at rest, once: a first run that was slow does not keep its first key from the page", () => {
  const text = "BLK\nTOOL CALL 7\nL X+3.5\nL Z-1.7\nM30\n";
  notePace(requestOf(text), 211.4);
  expect(run.rehearsed).toEqual([text.slice(0, 16), text.slice(0, 24), text.slice(0, 32), text]);
  expect(plans(text)).toBe(true);
  notePace(requestOf(text), 9.7);
  expect(run.rehearsed).toHaveLength(4);
});

test("nothing is tried at rest that took long, or is very long", () => {
  notePace(requestOf("L X+3.5\n"), 601.3);
  expect(plans()).toBe(false);
  forgetPace();
  notePace(requestOf("L X+3.5\n", 400_000), 311.7);
  notePace(requestOf("L X+3.5\n", 20_000), 4001);
  expect([run.rehearsed, run.bits]).toEqual([[], 0]);
});

test("a long text whose first run was slow is planned on the page when three runs in a row were quick", () => {
  const text = "L".repeat(400_001),
    took = (pace: number) => {
      notePace(requestOf(text), pace);
      return plansOnPage(text.length);
    };
  expect([311.7, 2.1, 1.9, 2.3].map(took)).toEqual([false, false, false, true]);
});

test("a long text is planned at rest bit by bit, and on the page from then on", () => {
  const heard: unknown[] = [],
    request = requestOf("CYCL CALL\n".repeat(2400));
  whenRehearsed((made) => heard.push(made));
  expect([plansLong(request), plansOnPage(request.text.length)]).toEqual([true, false]);
  notePace(request, 1311.4);
  expect([run.bits, run.now.toFixed(1), heard, run.rehearsed]).toEqual([7, "48.3", [{}], []]);
  expect([plansLong(request), planNow(request) !== null]).toEqual([false, true]);
  forgetPace();
  expect(plansLong(request)).toBe(true);
});

test("what is typed into a long text before there was a rest is planned bit by bit, with the page answering in between", async () => {
  const request = requestOf("CYCL CALL\n".repeat(2400)),
    done = vi.fn();
  expect(planSoon(request, done)).toBeNull();
  run.rests = false;
  notePace(request, 1311.4);
  for (const took of [11.3, 9.1, 12.7]) notePace(request, took);
  expect(planNow(request)).toBeNull();
  const callOff = planSoon(request, done);
  for (let turn = 0; turn < 2; turn += 1) await new Promise((next) => setTimeout(next));
  expect(run.bits).toBe(2);
  callOff?.();
  const before = run.bits;
  await new Promise((rest) => setTimeout(rest, 30));
  expect([run.bits, done.mock.calls.length]).toEqual([before, 0]);
  planSoon(request, done);
  await vi.waitFor(() => expect(done).toHaveBeenCalledWith(expect.objectContaining({ text: request.text })));
  expect([planSoon(request, done), planNow(request) !== null]).toEqual([null, true]);
});

test("what was called off goes on at the next rest", () => {
  run.rests = false;
  const request = requestOf("CYCL CALL\n".repeat(2400));
  notePace(request, 1311.4);
  planSoon(request, () => undefined)?.();
  run.rests = true;
  notePace(request, 11.3);
  expect([run.bits, planNow(request) !== null]).toEqual([7, true]);
});

test("one whose first run took so long that nobody waits for it is left to the worker until it was planned at rest", () => {
  run.rests = false;
  const request = requestOf("CYCL CALL\n".repeat(2400));
  for (const took of [1511.4, 11.3, 9.1, 12.7]) notePace(request, took);
  expect([planSoon(request, () => undefined), planNow(request)]).toEqual([null, null]);
});
