import { expect, test } from "vitest";
import { trackOf } from "./playback.ts";
import { operationAt, timeBar, TOOL_TONES, toolTones, type TimedStep } from "./timeline.ts";

const step = (
  kind: string,
  seconds: number,
  operation: number | null = 0,
): TimedStep & { readonly seconds: number } => ({
  move: { kind },
  operation,
  seconds,
});

test("the bar has a stretch for each run of cuts and of rapids, as parts of the time", () => {
  const steps = [step("rapid", 1.7), step("feed", 3), step("arc", 2.1), step("rapid", 1), step("feed", 2.2)];
  expect(timeBar(steps, trackOf(steps))).toMatchObject({
    rapid: "M0 0H0.17V1H0ZM0.68 0H0.78V1H0.68Z",
    cutting: "M0.17 0H0.68V1H0.17ZM0.78 0H1V1H0.78Z",
    operations: [{ operation: 0, from: 0, to: 1 }],
  });
});

test("stretches too short for any screen are merged, and no time is lost", () => {
  const steps = Array.from({ length: 50_000 }, (_, i) =>
    step(i % 2 === 0 ? "feed" : "rapid", i % 2 === 0 ? 0.31 : 0.02),
  );
  const { cutting, rapid } = timeBar(steps, trackOf(steps));
  expect(cutting).toMatch(/^M0 0H(?:0\.9999\d*|1)V1H0Z$/);
  expect(rapid).toMatch(/^M0\.0000\d+ 0H1V1H0\.0000\d+Z$/);
});

test("a step without duration has no stretch, and a resumed call has two entries", () => {
  const steps = [step("rapid", 0), step("feed", 4, 0), step("feed", 1, null), step("feed", 5, 0), step("rapid", 0, 1)];
  const { rapid, operations } = timeBar(steps, trackOf(steps));
  expect(rapid).toBe("");
  expect(operations.map(({ operation, from, to }) => [operation, from, to])).toEqual([
    [0, 0, 0.4],
    [0, 0.5, 1],
    [1, 1, 1],
  ]);
});

test("a place on the bar belongs to an operation, or to none", () => {
  const steps = [step("feed", 2, 0), step("rapid", 2, null), step("feed", 4, 1), step("feed", 2, 0)];
  const bar = timeBar(steps, trackOf(steps));
  expect([0, 0.1, 0.3, 0.5, 0.9, 1].map((at) => operationAt(bar, at))).toEqual([0, 0, null, 1, 0, 0]);
});

test("operations with the same tool have the same colour; colours start again when there are none left", () => {
  expect(toolTones([15, 1, 1, 3, 15])).toEqual([0, 1, 1, 2, 0]);
  expect(toolTones(Array.from({ length: TOOL_TONES + 1 }, (_, i) => i + 1)).at(-1)).toBe(0);
});
