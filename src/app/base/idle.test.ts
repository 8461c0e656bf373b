import { afterEach, expect, test, vi } from "vitest";
import { scheduleIdle } from "./idle.ts";

afterEach(() => vi.unstubAllGlobals());

/** After how many of these idle periods, ms, a callback runs that needs 25 ms; null: it never runs. */
function runsAfter(rests: readonly number[]): number | null {
  const waiting: IdleRequestCallback[] = [];
  let ran = false;
  vi.stubGlobal("requestIdleCallback", (look: IdleRequestCallback) => waiting.push(look));
  scheduleIdle(() => (ran = true), 25);
  const found = rests.findIndex((rest) => {
    waiting.shift()?.({ didTimeout: false, timeRemaining: () => rest });
    return ran;
  });
  return found < 0 ? null : found + 1;
}

test("it waits for a long idle period, or for many frames in a row that take little", () => {
  expect(runsAfter([3.1, 14.2, 41.7])).toBe(3);
  expect(runsAfter(Array(40).fill(12.3))).toBe(8);
  expect(runsAfter(Array.from({ length: 40 }, (_, i) => (i % 7 === 6 ? 2.2 : 13.1)))).toBeNull();
  expect(runsAfter(Array(40).fill(5.4))).toBeNull();
});
