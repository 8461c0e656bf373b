import { beforeEach, expect, test, vi } from "vitest";
import { fetchPlan, forgetPace, notePace, planNow, plansOnPage } from "./page-plan.ts";
import type { Request } from "./request.ts";

/** What the next run takes, ms, and whether it comes to nothing. */
const run = vi.hoisted(() => ({ takes: 0, fails: false, now: 0 }));
vi.mock("../clock.ts", () => ({ stopwatch: () => run.now }));
vi.mock("../rest.ts", () => ({
  atRest: (begin: () => void) => {
    begin();
    return () => undefined;
  },
}));
vi.mock("./plan.ts", () => ({
  planner: () => ({ version, text }: Request) => {
    run.now += run.takes;
    if (run.fails) throw new Error("a fault of our own");
    return { version, text, run: {}, simulation: null };
  },
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
  Object.assign(run, { takes: 1.3, fails: false, now: 0 });
  forgetPace();
  fetchPlan();
  await vi.waitFor(() => expect(plansOnPage(17)).toBe(true));
});

test("a short text is planned at once, a long one not before it is known to be quick", () => {
  expect(planNow(requestOf("L X+3.5"))).toMatchObject({ version: 7, text: "L X+3.5" });
  forgetPace();
  expect(plans("L".repeat(20_001))).toBe(false);
  expect(planNow(requestOf("L X+3.5", 20_000))).toBeNull();
  notePace(19.6);
  expect(plans("L".repeat(20_001))).toBe(true);
});

test("what takes longer is left to the worker, until it takes less there", () => {
  run.takes = 23.7;
  expect([plans(), plans()]).toEqual([true, false]);
  notePace(undefined);
  expect(plans()).toBe(false);
  notePace(4.9);
  expect(plans()).toBe(true);
});

test("a run that had to wait once is no slow run; three of them are", () => {
  expect(plans()).toBe(true);
  run.takes = 41.2;
  expect([plans(), plans(), plans(), plans()]).toEqual([true, true, true, false]);
});

test("a plan that fails is left to the worker, which says so", () => {
  run.fails = true;
  expect(plans()).toBe(false);
  expect(plansOnPage(17)).toBe(true);
});
