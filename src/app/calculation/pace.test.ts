import { expect, test } from "vitest";
import { isQuick, isSlow, lengthOf, mayWarmUp, UNKNOWN_PACE, withRun, withRunInWorker } from "./pace.ts";

const onPage = (runs: readonly number[]) => runs.reduce(withRun, UNKNOWN_PACE);
const inWorker = (runs: readonly number[]) => runs.reduce(withRunInWorker, UNKNOWN_PACE);

test.each<[what: string, characters: number, runs: readonly number[], isPlannedAhead: boolean, quick: boolean]>([
  ["a short text of which nothing is known", 20_000, [], false, true],
  ["a long one of which nothing is known", 20_001, [], false, false],
  ["a short one that is planned ahead", 20_000, [9.3], true, true],
  ["a long one that is planned ahead", 20_001, [311.7, 2.1, 1.9, 2.3], true, false],
  ["a long one whose first run was quick", 20_001, [59.6], true, true],
  ["a very long one after two quick runs", 400_001, [311.7, 2.1, 1.9], false, false],
  ["a very long one after three", 400_001, [311.7, 2.1, 1.9, 2.3], false, true],
])("%s", (_, characters, runs, isPlannedAhead, quick) => {
  expect(isQuick(inWorker(runs), characters, isPlannedAhead)).toBe(quick);
});

test.each<[runs: readonly number[], quick: boolean]>([
  [[60], true],
  [[61.2], false],
  [[1.3, 61.2, 61.2], true],
  [[1.3, 61.2, 61.2, 61.2], false],
  [[61.2, 61.2, 61.2, 59.4], true],
])("one of the last three runs of a short text has to be quick: %j is %j", (runs, quick) => {
  expect(isQuick(onPage(runs), 17, false)).toBe(quick);
});

test.each<[runs: readonly number[], slow: boolean]>([
  [[3.2, 61.1, 2.9], false],
  [[3.2, 61.1, 2.9, 60.7], true],
  [[61.1, 2.9, 60.7, 2.8], true],
  [[61.1, 2.9, 60.7, 2.8, 3.1], false],
  [[3.1, 180.5, 2.6, 59.9], false],
])("a digit comes before its path when two of the last four runs were slow: %j is %j", (runs, slow) => {
  expect(isSlow(onPage(runs))).toBe(slow);
});

test.each<[characters: number, took: number, may: boolean]>([
  [20_000, 600, true],
  [20_000, 601.3, false],
  [20_001, 4000, true],
  [20_001, 4001, false],
  [400_000, 311.7, true],
  [400_001, 311.7, false],
])("%d characters that took %d ms are planned ahead: %j", (characters, took, may) => {
  expect(mayWarmUp(characters, took)).toBe(may);
});

test("the first run in the worker sets the pace of a work, and its other files count to its length", () => {
  expect(inWorker([1311.4, 9.3])).toMatchObject({ first: 1311.4, isKnown: false });
  expect(inWorker([60, 1311.4])).toMatchObject({ first: 60, isKnown: true });
  expect(lengthOf({ text: "L X+3.5", files: [{ name: "B.H", text: "M30" }] })).toBe(10);
});
