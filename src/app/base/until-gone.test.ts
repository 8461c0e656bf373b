import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { takeAnswer, untilGone } from "./until-gone.ts";

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

/** When somebody leaves: never, before the pause is over, or before the answer is there. */
const CASES = [
  { leaves: "never", asked: 1, taken: ["answer"] },
  { leaves: "in the pause", asked: 0, taken: [] },
  { leaves: "before the answer", asked: 1, taken: [] },
] as const;

test.each(CASES)("an answer is taken while somebody waits for it: leaves $leaves", async ({ leaves, asked, taken }) => {
  const ask = vi.fn(async () => await Promise.resolve("answer")),
    told: string[] = [];
  const end = takeAnswer(ask, (answer) => told.push(answer), 50);
  vi.advanceTimersByTime(49);
  expect(ask).not.toHaveBeenCalled();
  if (leaves === "in the pause") end();
  vi.advanceTimersByTime(1);
  if (leaves === "before the answer") end();
  await vi.runAllTimersAsync();
  expect(ask).toHaveBeenCalledTimes(asked);
  expect(told).toEqual(taken);
});

test("without a pause work begins at once, and goes on until it is ended", async () => {
  const told: number[] = [];
  const end = untilGone(async (isGone) => {
    for (let i = 0; i < 3 && !isGone(); i += 1) {
      told.push(i);
      await Promise.resolve();
    }
  });
  expect(told).toEqual([0]);
  await Promise.resolve();
  end();
  await vi.runAllTimersAsync();
  expect(told).toEqual([0, 1]);
});
