import { describe, expect, test } from "vitest";
import {
  cycleOfParameter,
  operationsPlayed,
  stepsPlayed,
  parameterValueIn,
  withParameterValue,
} from "./playback-range.ts";

const steps = [6, 8, 9, 9, 9, 10, 11].map((block) => ({ block }));

describe("played steps", () => {
  test.each([
    [undefined, { first: 0, last: 6 }],
    [
      { from: 9, to: 9 },
      { first: 2, last: 4 },
    ],
    [
      { from: 8, to: 10 },
      { first: 1, last: 5 },
    ],
    [
      { from: 7, to: 9 },
      { first: 1, last: 4 },
    ],
    [
      { from: 20, to: 30 },
      { first: 0, last: 6 },
    ],
  ])("%j", (blocks, wanted) => expect(stepsPlayed(steps, blocks)).toEqual(wanted));

  test("an empty program plays nothing", () =>
    expect(stepsPlayed([], { from: 1, to: 3 })).toEqual({ first: 0, last: -1 }));

  test("the calls within the steps, except those that cut nothing", () => {
    const calls = [
      { firstStep: 0, lastStep: 1 },
      { firstStep: 2, lastStep: 4 },
      { firstStep: 5, lastStep: 4 },
      {
        firstStep: 5,
        lastStep: 6,
      },
    ];
    expect(operationsPlayed(calls, { first: 2, last: 4 })).toEqual([calls[1]]);
    expect(operationsPlayed(calls, { first: 1, last: 5 })).toEqual([calls[0], calls[1], calls[3]]);
  });
});

describe("a value with a slider", () => {
  const lines = [
    "7 CYCL DEF 811 ~",
    "Q463=+2.5 ;MAX. CUTTING DEPTH ~",
    "  Q494=-35 ;CONTOUR END IN Z ~",
    "Q4630=+1 ~",
    "11 Q463=+3",
  ];
  test("changes only its own parameter, with a sign", () => {
    expect(withParameterValue(lines, "Q463", 0.1 + 0.2)).toEqual([
      lines[0],
      "Q463=+0.3 ;MAX. CUTTING DEPTH ~",
      lines[2],
      lines[3],
      lines[4],
    ]);
    expect(withParameterValue(lines, "Q494", -31.25)[2]).toBe("  Q494=-31.25 ;CONTOUR END IN Z ~");
    expect(withParameterValue(lines, "Q494", 0)[2]).toBe("  Q494=+0 ;CONTOUR END IN Z ~");
  });
  test("is read where it is first set", () => {
    expect(parameterValueIn(lines, "Q463")).toBe(2.5);
    expect(parameterValueIn(lines, "Q494")).toBe(-35);
    expect(parameterValueIn(lines, "Q500")).toBeNull();
  });
  test("belongs to the previous cycle, whose own line may contain it", () => {
    const program = [
      "6 CYCL DEF 800 ADJUST XZ SYSTEM ~",
      "Q530=+0",
      ...lines,
      "12 CYCL DEF 812 SHOULDER ~",
      "Q491=+75 ~",
    ];
    expect(["Q530", "Q463", "Q494", "Q491", "Q492"].map((q) => cycleOfParameter(program, q))).toEqual([
      800,
      811,
      811,
      812,
      null,
    ]);
  });
});
