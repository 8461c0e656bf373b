import { describe, expect, test } from "vitest";
import { TASK_FORMAT, taskSchema } from "../../src/course/task.ts";
import { judged, refusedBy } from "./hand-turned.ts";

/** A bar with a thread cut by cycle 831, outside or in a bore; `undefined`: without a thread. */
function program(pitch: number | undefined, { depth = 0, to = -31.4, inside = false } = {}): string {
  const prompts: Record<string, number> = {
    Q471: inside ? 1 : 0,
    Q460: inside ? 2 : 5,
    Q491: inside ? 33.7 : 30,
    Q472: pitch ?? 2,
    Q473: depth,
    Q492: 0,
    Q494: to,
    Q474: 0,
    Q463: 0.3,
    Q467: 29,
    Q468: 0,
    Q470: 0,
    Q475: 1,
    Q476: 0,
  };
  return [
    "0 BEGIN PGM THREAD MM",
    `1 BLK FORM CYLINDER Z ${inside ? "D60 L70 DIST+0 DI31.535" : "D30 L70 DIST+0"}`,
    "2 FUNCTION MODE TURN",
    `3 TOOL CALL ${inside ? 13 : 12}`,
    "4 FUNCTION TURNDATA SPIN VCONST:OFF S700",
    "5 M136",
    "6 L X+100 Z+60 R0 FMAX M303",
    ...(pitch === undefined
      ? []
      : [
          "7 CYCL DEF 831 THREAD LONGITUDINAL ~",
          Object.entries(prompts)
            .map(([q, v]) => `${q}=${v} ;X`)
            .join(" ~\n"),
          `8 L X+${inside ? 27 : 40} Z+7 FMAX`,
          "9 CYCL CALL",
        ]),
    "10 L Z+60 FMAX",
    "11 M30",
    "12 END PGM THREAD MM",
  ].join("\n");
}
const task = (pitch: number | undefined, inside = false) =>
  taskSchema.parse({
    format: TASK_FORMAT,
    id: "law",
    kind: "make",
    start: { empty: true },
    part: {
      blank: [`BLK FORM CYLINDER Z ${inside ? "D60 L70 DIST+0 DI31.535" : "D30 L70 DIST+0"}`],
      threads: [
        inside
          ? { from: 0, to: -31.4, crest: 31.535, root: 33.7, pitch, name: "M33.7×2" }
          : { from: 0, to: -31.4, crest: 30, root: 27.5, pitch, name: "M30×2" },
      ],
    },
    rules: { missing: 2 },
    words: {},
  });
const markOf = (text: string, asked: number | undefined, inside = false) => {
  const judgement = judged(task(asked, inside), text);
  return { judgement, mark: judgement.marks.find((m) => m.rule === "residue" && m.about !== undefined) };
};

describe("a thread", () => {
  test("exists outside and inside, with its pitch", () => {
    for (const inside of [false, true]) {
      const { judgement, mark } = markOf(program(2, { inside }), 2, inside);
      expect(refusedBy(judgement)).toEqual([]);
      expect(mark?.value).toBeCloseTo(2, 1);
    }
  });
  test("of another pitch is refused by the call that cuts it, unless the task states none", () => {
    for (const pitch of [1.75, 1.95, 2.5]) {
      const { mark } = markOf(program(pitch, { depth: 1.2 }), 2);
      expect(mark).toMatchObject({ passed: false, limit: 2, operation: 0, block: 9 });
      expect(mark?.value).toBeCloseTo(pitch, 1);
    }
    expect(refusedBy(markOf(program(1.75, { depth: 1.2 }), undefined).judgement)).toEqual([]);
  });
  test("that is missing, too shallow or too short leaves material", () => {
    expect(refusedBy(markOf(program(undefined), 2).judgement)).toEqual(["residue"]);
    expect(refusedBy(markOf(program(2, { depth: 0.9 }), 2).judgement)).toEqual(["residue"]);
    expect(refusedBy(markOf(program(2, { to: -22 }), 2).judgement)).toEqual(["residue"]);
  });
});
