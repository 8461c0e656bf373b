import { expect, test } from "vitest";
import { at } from "../kernel/geometry/point.ts";
import type { Step } from "../kernel/time/step.ts";
import { feed } from "../kernel/units.ts";
import { shippedTools } from "../program/tools/shipped-tools.ts";
import { MOST_STRETCHES, pathStretches, progressOf, wholePath, type KnownLines } from "./passes.ts";
import { toolpath } from "./scene.ts";

/** Steps of so many passes of one call: rapid to the cut, cut, lift off, back. */
function passes(count: number, operation: number | null = 0): Step[] {
  const tool = shippedTools[0];
  if (!tool) throw new Error("no tool");
  const out: Step[] = [];
  let from = at(2, 30);
  for (let i = 0; i < count; i += 1) {
    const r = 29.3 - i * 0.01;
    const purpose = { phase: "rough", run: "rough", step: 1, ...(operation !== null && { pass: i + 1 }) } as const;
    for (const move of [
      { kind: "rapid", to: at(2, r), ...purpose },
      { kind: "feed", to: at(-17.3, r), feed: feed(0.3), feedUnit: "mm/rev", ...purpose },
      { kind: "feed", to: at(-17.3, r + 0.7), feed: feed(0.3), feedUnit: "mm/rev", ...purpose },
      { kind: "rapid", to: at(2, r + 0.7), ...purpose },
    ] as const) {
      out.push({ from, move, tool, block: 1, operation, seconds: 1 });
      from = move.to;
    }
  }
  return out;
}

test("each pass is a stretch of its own, and all of them together are the path", () => {
  const steps = passes(7),
    stretches = pathStretches(steps);
  expect(stretches.map(({ first, last }) => [first, last])).toEqual(
    [0, 1, 2, 3, 4, 5, 6].map((i) => [4 * i, 4 * i + 3]),
  );
  expect(stretches[2]?.shapes).toEqual(toolpath(steps.slice(8, 12)));
  const whole = wholePath(stretches);
  expect(whole.map(({ role }) => role)).toEqual(["rapid", "feed"]);
  // A stretch begins where the previous one ended: every line is drawn once.
  const lines = (d: string | undefined) => d?.split("L").length;
  expect(whole.map(({ d }) => lines(d))).toEqual(toolpath(steps).map(({ d }) => lines(d)));
  expect(stretches[2]?.shapes.map(({ role }) => role)).toEqual(["rapid", "feed"]);
});

test("between the cycles a rapid after a cut begins the next stretch", () => {
  expect(pathStretches(passes(3, null)).map(({ first, last }) => [first, last])).toEqual([
    [0, 2],
    [3, 6],
    [7, 10],
    [11, 11],
  ]);
});

test.each([97, 500, 12_500])("%i passes make no more stretches than allowed, without a gap", (count) => {
  const steps = passes(count),
    stretches = pathStretches(steps);
  expect(stretches.length).toBeGreaterThan(MOST_STRETCHES / 3);
  expect(stretches.length).toBeLessThanOrEqual(MOST_STRETCHES);
  stretches.forEach(({ first, last }, i) => {
    expect(first).toBe((stretches[i - 1]?.last ?? -1) + 1);
    expect((last + 1) % 4).toBe(0);
  });
  expect(stretches.at(-1)?.last).toBe(steps.length - 1);
});

test("a part of a run keeps the numbers of its steps", () => {
  expect(pathStretches(passes(9), 8, 18).map(({ first, last }) => [first, last])).toEqual([
    [8, 11],
    [12, 15],
    [16, 18],
  ]);
  expect(pathStretches([])).toEqual([]);
});

test("stretches before the running step are done, forwards and backwards", () => {
  const stretches = pathStretches(passes(4));
  const at = (step: number) => stretches.map((each) => progressOf(each, step)[0]).join("");
  expect([0, 3, 4, 11, 15, 16, 5].map(at)).toEqual(["rccc", "rccc", "drcc", "ddrc", "dddr", "dddd", "drcc"]);
});

test("when one call of many changes, the lines of all others are reused", () => {
  const call = (operation: number, count: number) => passes(count, operation);
  const calls = Array.from({ length: 31 }, (_, i) => call(i, 33 + (i % 3))),
    known: KnownLines = new WeakMap();
  const stretchesOf = (steps: readonly Step[]) => pathStretches(steps, 0, steps.length - 1, 24, known);
  const before = stretchesOf(calls.flat()),
    changed = stretchesOf(calls.with(20, call(20, 41)).flat());
  expect(before).toHaveLength(31);
  const isNew = changed.map(({ shapes }, i) => shapes !== before[i]?.shapes);
  expect(isNew.flatMap((is, i) => (is ? [i] : []))).toEqual([20]);
  expect(changed.map(({ shapes }) => shapes)).toEqual(
    pathStretches(calls.with(20, call(20, 41)).flat(), 0, undefined, 24).map((s) => s.shapes),
  );
  expect(changed[25]?.first).toBe((before[25]?.first ?? 0) + 4 * (41 - 35));
});
