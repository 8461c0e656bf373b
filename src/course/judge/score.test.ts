import { describe, expect, test } from "vitest";
import { at, type Ring } from "../../kernel/geometry/point.ts";
import type { TargetPart } from "../target-part.ts";
import { RULES, type Answer, type RuleName, type TaskMark } from "./judgement.ts";
import { scoreOf } from "./score.ts";

const box = (length: number, r: number): Ring => [at(-length, 0), at(0, 0), at(0, r), at(-length, r)];
const mark = (rule: RuleName, passed: boolean, more: Partial<TaskMark> = {}): TaskMark => ({ rule, passed, ...more });

interface Given {
  /** mm² of the half section beyond the part, and how much of it is allowed. */
  readonly left?: number;
  readonly residue?: number;
  readonly seconds?: number;
  readonly tools?: number;
  readonly marks?: readonly TaskMark[];
}

/** 600 mm² to cut from a bar of 30 mm to a part of 20 mm; par is 60 s and 2 tools. */
function pointsOf({ left = 0, residue = 0, seconds = 60, tools = 2, marks = [mark("errors", true)] }: Given) {
  const wanted = { blank: [box(60, 30)], rings: [box(60, 20)] } as unknown as TargetPart;
  const answer = {
    text: Array.from({ length: tools }, (_, i) => `TOOL CALL ${i + 1}`).join("\n"),
    run: { steps: [], operations: [] },
    simulation: {
      final: [box(60, 20 + left / 60)],
      steps: [{ from: at(0, 0), move: { kind: "feed", to: at(0, 0) }, seconds }],
    },
  } as unknown as Answer;
  const { total, parts } = scoreOf({ seconds: 60, tools: 2 }, wanted, residue, answer, marks);
  const points = parts.map((p) => p.points);
  expect(total).toBe(points.reduce((sum, p) => sum + p, 0));
  expect(parts.map((p) => [p.what, p.of])).toEqual([
    ["proof", 40],
    ["residue", 20],
    ["time", 25],
    ["tools", 15],
  ]);
  return { points, parts };
}

describe("the points of a free program", () => {
  test.each<[string, Given, readonly [proof: number, residue: number, time: number, tools: number]]>([
    ["as good as par", {}, [40, 20, 25, 15]],
    ["better than par", { seconds: 30, tools: 1 }, [40, 20, 25, 15]],
    ["twice the time", { seconds: 120 }, [40, 20, 13, 15]],
    ["no time at all", { seconds: 0 }, [40, 20, 0, 15]],
    ["four tools", { tools: 4 }, [40, 20, 25, 8]],
    ["no tool at all", { tools: 0 }, [40, 20, 25, 0]],
    // 5 % of 600 mm² earn no points.
    ["a third of the residue", { left: 10 }, [40, 13, 25, 15]],
    ["residue as allowed", { left: 10, residue: 10 }, [40, 20, 25, 15]],
    ["residue beyond what is allowed", { left: 25, residue: 10 }, [40, 10, 25, 15]],
    ["all of the residue", { left: 45 }, [40, 0, 25, 15]],
    [
      "one of two rules broken, twice",
      { marks: [mark("errors", true), mark("speed", true), mark("speed", false), mark("speed", false)] },
      [20, 20, 25, 15],
    ],
    ["residue is not a rule of the proof", { marks: [mark("errors", true), mark("residue", false)] }, [40, 20, 25, 15]],
    [
      "a thread that is not there",
      { marks: [mark("errors", true), mark("residue", false, { about: "M30" })] },
      [40, 0, 25, 15],
    ],
    [
      "a thread that is there",
      { marks: [mark("errors", true), mark("residue", true, { about: "M30" })] },
      [40, 20, 25, 15],
    ],
  ])("%s", (_, given, points) => expect(pointsOf(given).points).toEqual(points));

  test("there are none for what breaks a tool or the part; any other rule costs only its share", () => {
    const never = RULES.filter((rule) =>
      pointsOf({ marks: [mark("words", true), mark(rule, false)] }).points.every((p) => p === 0),
    );
    expect(never).toEqual(["errors", "unproved", "blank", "rapid", "holder", "gouge", "missing"]);
  });

  test("each part says what was measured and what was asked", () => {
    const { parts } = pointsOf({
      left: 30,
      residue: 12,
      seconds: 75,
      tools: 3,
      marks: [mark("errors", true), mark("speed", false)],
    });
    expect(parts.map(({ value, par }) => [Math.round(value * 10) / 10, par])).toEqual([
      [1, 2],
      [30, 12],
      [75, 60],
      [3, 2],
    ]);
  });
});
