import { readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { answerOf } from "../../src/course/judge/answer.ts";
import { judge } from "../../src/course/judge/judge.ts";
import { isRight, truthOf } from "../../src/course/judge/predicting.ts";
import { taskSchema, type Prediction } from "../../src/course/task.ts";
import { at } from "../../src/kernel/geometry/point.ts";
import { judged, programOf, taskOf, type Shoulder } from "./hand-turned.ts";

const s: Shoulder = { outer: 71.3, diameter: 64.18, length: 27.45 };
const cycle = (q215: number) => [
  "6 CYCL DEF 811 SHOULDER, LONGIT. ~",
  `Q215=+${q215} ;X ~\nQ460=+2 ;X ~\nQ493=+64.18 ;X ~\nQ494=-27.45 ;X ~\nQ463=+1.3 ;X ~\nQ478=+0.3 ;X ~`,
  "Q483=+0.4 ;X ~\nQ484=+0.2 ;X ~\nQ505=+0.15 ;X ~\nQ506=+0 ;X",
];
const text = programOf(
  { ...s, diameter: s.outer + 3 },
  {
    blank: "BLK FORM CYLINDER Z D71.3 L59.15 DIST+0",
    before: cycle(0),
    cuts: ["7 L X71.3 FMAX", "8 CYCL CALL"],
  },
);
const truth = (asked: Prediction, program = text) => truthOf(asked, taskOf(s), answerOf(program));

describe("predictions", () => {
  test("passes, infeed and sizes are those of the run", () => {
    // 3.56 mm minus 0.2 mm of oversize, in passes of at most 1.3 mm: three of 1.12 mm.
    expect(truth({ ask: "passes" })).toEqual({ kind: "number", value: 3 });
    const infeed = truth({ ask: "infeed", operation: 0 });
    expect(isRight({ ask: "infeed", operation: 0 }, infeed, 1.12)).toBe(true);
    expect(isRight({ ask: "infeed", operation: 0 }, infeed, 1.13)).toBe(false);
    expect(isRight({ ask: "infeed", within: 0.2 }, infeed, 1.3)).toBe(true);
    const size = { ask: "diameter", at: -11 } as const;
    expect(isRight(size, truth(size), 64.18)).toBe(true);
    expect(isRight(size, truth(size), 64.2)).toBe(false);
    expect(isRight({ ask: "passes" }, truth({ ask: "passes" }), 3)).toBe(true);
    expect(isRight({ ask: "passes" }, truth({ ask: "passes" }), 2)).toBe(false);
  });

  test("nothing is right where the run has no such thing", () => {
    expect(truth({ ask: "passes", operation: 1 })).toEqual({ kind: "number", value: null });
    expect(isRight({ ask: "passes", operation: 1 }, truth({ ask: "passes", operation: 1 }), 0)).toBe(false);
    const rapid = { ask: "rapidPlace", within: 3 } as const;
    expect(truth(rapid)).toEqual({ kind: "place", place: null, rings: [] });
    expect(isRight(rapid, truth(rapid), at(0, 0))).toBe(false);
  });

  test("places are right on the region and near it", () => {
    const thin = programOf({ ...s, diameter: 63.4 });
    const gouge = { ask: "gougePlace", within: 1.5 } as const;
    const found = truth(gouge, thin);
    expect(isRight(gouge, found, at(-13, 31.9))).toBe(true);
    expect(isRight(gouge, found, at(-2, 33.4))).toBe(true);
    expect(isRight(gouge, found, at(-13, 34.1))).toBe(false);
    const left = { ask: "residuePlace", within: 3 } as const;
    const short = programOf({ ...s, length: 24 }, { blank: "BLK FORM CYLINDER Z D71.3 L59.15 DIST+0" });
    expect(isRight(left, truth(left, short), at(-25.5, 34))).toBe(true);
    expect(isRight(left, truth(left, short), at(-10, 34))).toBe(false);
    const run = { ask: "rapidPlace", within: 2 } as const;
    const crash = truth(run, programOf(s, { cuts: ["7 L Z-9 FMAX", "7 L Z-27.45 F0.2", "8 L X75"] }));
    expect(isRight(run, crash, at(-4, 33))).toBe(true);
    expect(isRight(run, crash, at(-14, 33))).toBe(false);
  });

  test("choices and blocks are those of the task", () => {
    expect(isRight({ ask: "choice", right: 2 }, truth({ ask: "choice", right: 2 }), 2)).toBe(true);
    expect(isRight({ ask: "choice", right: 2 }, truth({ ask: "choice", right: 2 }), 0)).toBe(false);
    const block = { ask: "block", right: [6, 8] } as const;
    expect(isRight({ ...block, right: [6, 8] }, truth({ ...block, right: [6, 8] }), 8)).toBe(true);
    expect(isRight({ ...block, right: [6, 8] }, truth({ ...block, right: [6, 8] }), 7)).toBe(false);
  });
});

describe("the score of a free program", () => {
  const seconds = answerOf(programOf(s)).simulation.totalSeconds;
  const drawing = taskOf(s, { kind: "drawing", par: { seconds, tools: 1 }, rules: { speed: 2500 } });

  test("is 100 for an answer as good as par, and never more", () => {
    expect(judged(drawing, programOf(s)).score?.total).toBe(100);
    expect(judge({ ...drawing, par: { seconds: 3 * seconds, tools: 3 } }, answerOf(programOf(s))).score?.total).toBe(
      100,
    );
  });

  test("decreases with more time and with more tools", () => {
    const parts = judged({ ...drawing, par: { seconds: seconds / 2, tools: 1 } }, programOf(s)).score?.parts;
    expect(parts?.find((p) => p.what === "time")).toMatchObject({
      points: Math.round(25 / 2),
      of: 25,
      par: seconds / 2,
    });
    const two = programOf(s, { before: ["5 TOOL CALL 3", "5 L X200 Z100 R0 FMAX", "5 TOOL CALL 1"] });
    expect(judged(drawing, two).score?.parts.find((p) => p.what === "tools")).toMatchObject({
      points: Math.round(15 / 2),
      value: 2,
    });
  });

  test("decreases with a broken rule and with excess material", () => {
    const fast = judged({ ...drawing, rules: { speed: 1000 } }, programOf(s)).score;
    expect(fast?.parts.find((p) => p.what === "proof")?.points).toBeLessThan(40);
    expect(fast?.parts.find((p) => p.what === "residue")?.points).toBe(20);
    // A band of 0.5 mm of 27.45 mm is 1.8 % of the material to cut; 5 % earn no points.
    const short = judged(
      drawing,
      programOf({ ...s, length: 26.95 }, { blank: "BLK FORM CYLINDER Z D71.3 L59.15 DIST+0" }),
    ).score;
    const share = (0.5 * 3.56) / (0.05 * 3.56 * 27.45);
    expect(Math.abs((short?.parts.find((p) => p.what === "residue")?.points ?? 0) - 20 * (1 - share))).toBeLessThan(
      1.2,
    );
  });

  test("is 0 with contour damage or a tool in material", () => {
    expect(judged(drawing, programOf({ ...s, diameter: 64 })).score?.total).toBe(0);
    expect(judged(drawing, programOf(s, { cuts: ["7 L Z-9 FMAX", "7 L Z-27.45 F0.2", "8 L X75"] })).score?.total).toBe(
      0,
    );
  });

  test("exists for drawings only", () => expect(judged(taskOf(s), programOf(s)).score).toBeUndefined());

  test("grooves of a thread are no damage; a cut collar behind them is", () => {
    const collar = glandTask();
    const gouge = { ask: "gougePlace", within: 1.5 } as const;
    const found = truthOf(gouge, collar, answerOf("program" in collar.start ? collar.start.program.join("\n") : ""));
    expect(isRight(gouge, found, at(-24.2, 15.7))).toBe(true);
    expect(isRight(gouge, found, at(-9.3, 13.1))).toBe(false);
  });
});

const glandTask = () =>
  taskSchema.parse(
    JSON.parse(readFileSync(new URL("../../src/course/tasks/l16-into-the-collar.json", import.meta.url), "utf8")),
  );
