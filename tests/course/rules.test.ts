import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { answerOf } from "../../src/course/judge/answer.ts";
import { judge } from "../../src/course/judge/judge.ts";
import { toolsOfTask } from "../../src/course/task-start.ts";
import type { Task } from "../../src/course/task.ts";
import type { Tool } from "../../src/kernel/plan/tool.ts";
import { length } from "../../src/kernel/units.ts";
import { parse } from "../../src/nc/parse.ts";
import { run } from "../../src/program/run/run.ts";
import { shippedTools } from "../../src/program/tools/shipped-tools.ts";
import { readList } from "../../src/program/tools/tool-list.ts";
import { simulate } from "../../src/sim/simulate.ts";
import "../seed.ts";
import { judged, mm, programOf, refusedBy, shoulders, taskOf, type Shoulder } from "./hand-turned.ts";

/* Every rule in pairs: an answer that it must refuse, and one that it must accept. */

const s: Shoulder = { outer: 63.4, diameter: 57.82, length: 33.65 };
const withRules = (rules: Task["rules"], more: Partial<Task> = {}) => taskOf(s, { rules, ...more });
const marks = (rules: Task["rules"], text: string) => judged(withRules(rules), text).marks;
const refuses = (rules: Task["rules"], text = programOf(s)) => refusedBy(judged(withRules(rules), text));

/** The same shoulder with cycle 811, its prompts in order. */
const called = (values: Readonly<Record<string, string>> = {}, before: readonly string[] = []) => {
  const all: Record<string, string> = {
    Q215: "+0",
    Q460: "+2",
    Q493: `+${s.diameter}`,
    Q494: `-${s.length}`,
    Q463: "+1.7",
    Q478: "+0.3",
    Q483: "+0.4",
    Q484: "+0.2",
    Q505: "+0.15",
    Q506: "+0",
    ...values,
  };
  return programOf(s, {
    before: [
      ...before,
      "6 CYCL DEF 811 SHOULDER, LONGIT. ~",
      Object.entries(all)
        .map(([q, v]) => `${q}=${v} ;X`)
        .join(" ~\n"),
    ],
    cuts: [`7 L X${s.outer} FMAX`, "8 CYCL CALL"],
  }).replace(`6 L X${s.diameter}`, `7 L X${s.outer + 3}`);
};

describe("rules of the shop", () => {
  test("programs with a cycle and by hand make the same part", () => expect(refuses({}, called())).toEqual([]));

  test("depth: the actual one, by hand and by cycle", () => {
    // 2.79 mm by hand in one pass; the cycle divides the remaining depth without the oversize, 2.59 mm.
    expect(refuses({ depth: 2.81 })).toEqual([]);
    const [deep] = marks({ depth: 2.7 }, programOf(s)).filter((m) => m.rule === "depth");
    expect(deep).toMatchObject({ passed: false, block: 7 });
    expect(deep?.value).toBeCloseTo(2.79, 2);
    expect(refuses({ depth: 1.3 }, called())).toEqual([]);
    const [two] = marks({ depth: 1.2 }, called()).filter((m) => m.rule === "depth");
    expect(two).toMatchObject({ passed: false, operation: 0, block: 8 });
    expect(two?.value).toBeCloseTo(2.59 / 2, 2);
  });

  test("speed: a constant one, a limit, and none", () => {
    expect(refuses({ speed: 2500 })).toEqual([]);
    expect(refuses({ speed: 2499 })).toEqual(["speed"]);
    const without = programOf(s, { spin: "FUNCTION TURNDATA SPIN VCONST:ON VC:180" });
    expect(refuses({ speed: 9999 }, without)).toEqual(["speed"]);
    expect(marks({ speed: 9999 }, without).find((m) => m.rule === "speed")?.block).toBe(4);
    const constant = programOf(s, { spin: "FUNCTION TURNDATA SPIN VCONST:OFF S1137" });
    expect(refuses({ speed: 1137 }, constant)).toEqual([]);
    expect(refuses({ speed: 1136 }, constant)).toEqual(["speed"]);
    // A value that is replaced before the first move never had an effect.
    expect(
      refuses(
        { speed: 1200 },
        programOf(s, { spin: "FUNCTION TURNDATA SPIN VCONST:OFF S4000\n4 FUNCTION TURNDATA SPIN VCONST:OFF S1137" }),
      ),
    ).toEqual([]);
  });

  test("tools: the only ones, and how many", () => {
    expect(refuses({ tools: [1, 3], mostTools: 1 })).toEqual([]);
    expect(refuses({ tools: [2] })).toEqual(["tools"]);
    const two = programOf(s, { before: ["5 TOOL CALL 3", "5 L X200 Z100 R0 FMAX", "5 TOOL CALL 1"] });
    expect(refuses({ mostTools: 1 }, two)).toEqual(["mostTools"]);
    expect(marks({ tools: [1] }, two).find((m) => m.rule === "tools" && !m.passed)).toMatchObject({
      about: 3,
      block: 5,
    });
    expect(refuses({ mostTools: 2, tools: [1, 3] }, two)).toEqual([]);
  });

  test("an impossible feed is an error, reported by the time where that is limited; a real feed per minute is none", () => {
    const slow = called().replace("5 M136\n", "");
    const [mark] = marks({}, slow).filter((m) => !m.passed);
    expect(mark).toMatchObject({
      rule: "errors",
      block: 6,
      q: "Q478",
      issue: { code: "feedUnlikely", data: { feed: 0.3, unit: "mm/min" } },
    });
    expect(refuses({}, slow.replace("Q478=+0.3", "Q478=+297").replace("Q505=+0.15", "Q505=+148.5"))).toEqual([]);
    expect(refuses({ seconds: 190 }, slow)).toEqual(["seconds"]);
    expect(refuses({ clean: true }, slow)).toEqual(["clean"]);
  });

  test("a recessing blade that a cycle pushes sideways is an error, a recess turning tool is none", () => {
    const by = (tool: number) => called().replace("TOOL CALL 1", `TOOL CALL ${tool}`);
    expect(marks({ residue: 9, missing: 9 }, by(10)).filter((m) => !m.passed)).toEqual([
      expect.objectContaining({
        rule: "errors",
        block: 8,
        issue: expect.objectContaining({ code: "toolCannotCutSideways" }) as unknown,
      }),
    ]);
    expect(refuses({ residue: 9, missing: 9 }, by(9))).toEqual([]);
  });

  test("seconds: as long as the path takes", () => {
    const seconds = judged(withRules({ seconds: 1 }), programOf(s)).marks.find((m) => m.rule === "seconds")?.value ?? 0;
    // Feed 0.2 along 35.65 mm at 180 m/min on ⌀57.82: n = 180000 / (π·57.82) = 990.9 rpm.
    expect(seconds).toBeGreaterThan((60 * 35.65) / (0.2 * 990.95));
    expect(refuses({ seconds: seconds - 0.01 })).toEqual(["seconds"]);
    expect(refuses({ seconds: seconds + 0.01 })).toEqual([]);
  });

  test("seconds and tools are those of tasks, independent of the answer's own program", () => {
    const text = programOf(s);
    const ran = (tools: readonly Tool[], rapid: number) => {
      const made = run(parse(text), { tools, rapid });
      return { text, run: made, simulation: simulate(made) };
    };
    const { value } =
      judge(withRules({ seconds: 1 }), ran(shippedTools, 99_999)).marks.find((m) => m.rule === "seconds") ?? {};
    expect(value).toBeCloseTo(answerOf(text).simulation.totalSeconds, 9);
    const { table } = readList(toolsOfTask(withRules({})));
    expect(judge(withRules({}), ran(table.tools, 10_000)).passed).toBe(true);
    const sharp = shippedTools.map((tool) => (tool.T === 1 ? { ...tool, CUTLENGTH: length(40) } : tool));
    expect(judge(withRules({}), ran(sharp, 10_000)).marks.filter((m) => !m.passed)).toEqual([
      {
        rule: "tools",
        passed: false,
        about: 1,
        block: 7,
      },
    ]);
  });

  test("cycles: required ones must cut, others are not allowed", () => {
    expect(refuses({ cycles: [811] }, called())).toEqual([]);
    expect(refuses({ cycles: [811] })).toEqual(["cycles"]);
    expect(refuses({ cycles: [811, 812] }, called())).toEqual(["cycles"]);
    expect(refuses({ without: [812] }, called())).toEqual([]);
    expect(refuses({ without: [811] }, called())).toEqual(["without"]);
    // By hand first, so that the cycle cuts nothing: it is called but not used.
    const hand = [`5 L X${s.diameter} Z2 R0 FMAX M303`, `6 L Z-${s.length} F0.2`, `6 L X${s.outer + 3}`, "6 L Z2 FMAX"];
    expect(refuses({ cycles: [811] }, called({}, hand))).toEqual(["cycles"]);
  });

  test("values: from and to, for one cycle or all; missing where no cycle has them", () => {
    expect(refuses({ values: [{ q: "Q463", from: 1.7, to: 1.7 }] }, called())).toEqual([]);
    expect(refuses({ values: [{ q: "Q463", to: 1.69 }] }, called())).toEqual(["values"]);
    expect(refuses({ values: [{ q: "Q463", from: 1.71 }] }, called())).toEqual(["values"]);
    expect(refuses({ values: [{ q: "Q463", cycle: 812, from: 1, to: 3 }] }, called())).toEqual(["values"]);
    expect(refuses({ values: [{ q: "Q463", from: 0, to: 9 }] })).toEqual(["values"]);
    const mark = marks(
      {
        values: [
          { q: "Q505", from: 0, to: 0.15 },
          { q: "Q478", to: 0.25 },
        ],
      },
      called(),
    ).find((m) => !m.passed);
    expect(mark).toMatchObject({ rule: "values", q: "Q478", entry: 1, value: 0.3, operation: 0 });
    expect(refuses({ values: [{ q: "Q463", from: 1.7, to: 1.7 }] }, called({ Q463: "+Q9" }, ["6 Q9 = 1.7"]))).toEqual(
      [],
    );
  });

  test("passes: the exact number", () => {
    expect(refuses({ passes: 2 }, called())).toEqual([]);
    expect(refuses({ passes: 3 }, called())).toEqual(["passes"]);
    expect(refuses({ passes: 3 }, called({ Q463: "+1" }))).toEqual([]);
    // Finishing alone has no roughing pass, whatever Q463 is.
    expect(refuses({ passes: 0 }, called({ Q215: "+2" }))).toEqual([]);
  });

  test("rz: f²/8r of the nose, on the stated stretch", () =>
    fc.assert(
      fc.property(shoulders, mm(0.08, 0.4), (other, feed) => {
        // Tool 3: its nose of 0.4 mm forms the surface alone up to 0.42 mm a turn.
        const rz = (1000 * feed * feed) / (8 * 0.4);
        const text = programOf(other, { feed, tool: 3 });
        const asked = (most: number) =>
          taskOf(other, { rules: { missing: 1, rz: [{ from: -2, to: -other.length + 2, most }] } });
        expect(refusedBy(judged(asked(rz * 1.001), text))).toEqual([]);
        const found = judged(asked(rz * 0.999), text);
        expect(refusedBy(found)).toEqual(["rz"]);
        expect(found.marks.find((m) => m.rule === "rz")?.value).toBeCloseTo(rz, 6);
        // Behind the shoulder nothing was turned, so there is no smooth surface.
        expect(
          refusedBy(
            judged(
              taskOf(other, {
                rules: { missing: 1, rz: [{ from: -other.length - 2, to: -other.length - 20, most: 99 }] },
              }),
              text,
            ),
          ),
        ).toEqual(["rz"]);
      }),
      { numRuns: 8 },
    ));

  test("words: in a block, as whole words, with any spacing and signs; never in a comment", () => {
    const marked = programOf(s).replace("5 M136", "5 M136 ; M13 APPR LCT");
    expect(refuses({ words: ["M136"] }, marked)).toEqual([]);
    expect(refuses({ words: ["M13"] }, marked)).toEqual(["words"]);
    expect(refuses({ words: ["APPR LCT"] }, marked)).toEqual(["words"]);
    expect(refuses({ words: ["SMAX", "vconst:on", "FMAX M303", "SMAX2500"] }, marked)).toEqual([]);
    expect(refuses({ words: ["SMAX250"] }, marked)).toEqual(["words"]);
    expect(refuses({ words: [`L X+${s.diameter} Z+2 R0`] }, marked)).toEqual([]);
    expect(refuses({ words: ["Q463=1.7"] }, called())).toEqual([]);
    expect(refuses({ words: ["Q463=1"] }, called())).toEqual(["words"]);
  });

  test("clean: warnings count only where the rule is set", () => {
    // No M303: the spindle is stopped, which is an error with or without the rule.
    const still = called().replace(" M303", "");
    expect(refuses({}, still)).toEqual(["errors"]);
    expect(refuses({ clean: true }, still)).toEqual(["errors"]);
    // The nose radius left in a sharp corner is no warning, with or without a target part.
    expect(refuses({ clean: true }, called())).toEqual([]);
    expect(refusedBy(judged({ ...withRules({ clean: true }), part: undefined }, called()))).toEqual([]);
  });

  test("an unsimulated block is not proved", () => {
    const calls = programOf(s).replace("10 M30", "9 CALL PGM OTHER.H\n10 M30");
    expect(refuses({}, calls)).toEqual(["unproved"]);
    expect(marks({}, calls).find((m) => m.rule === "unproved")).toMatchObject({ block: 9, about: "CALL PGM" });
  });

  test("an error in a block is reported with its block", () => {
    const broken = called({ Q463: "-1" });
    expect(refuses({}, broken)).toContain("errors");
    expect(marks({}, broken).find((m) => m.rule === "errors" && m.q === "Q463")?.block).toBe(6);
  });
});

describe("sizes", () => {
  const sized = (sizes: Task["sizes"]) => withRules({}, { sizes });
  const tells = (sizes: Task["sizes"], text = programOf(s)) => refusedBy(judged(sized(sizes), text));
  test("are measured on the made part", () => {
    const right = [
      { kind: "diameter", at: -17, nominal: 57.8, upper: 0.02, lower: 0 },
      { kind: "diameter", at: -40, nominal: 63.4, upper: 0, lower: 0 },
      { kind: "face", at: 61, nominal: -33.6, upper: 0, lower: -0.05 },
      { kind: "face", at: 20, nominal: 0, upper: 0, lower: 0 },
    ] as const;
    expect(tells([...right])).toEqual([]);
    expect(tells([{ ...right[0], upper: 0.019 }])).toEqual(["size"]);
    expect(tells([{ ...right[0], lower: 0.021, upper: 0.1 }])).toEqual(["size"]);
    expect(tells([{ ...right[2], lower: -0.049 }])).toEqual(["size"]);
    const found = judged(sized([right[1], { ...right[0], upper: 0.019 }]), programOf(s)).marks.filter(
      (m) => m.rule === "size",
    );
    expect(found.find((m) => !m.passed)).toMatchObject({ size: 1 });
    expect(found.find((m) => !m.passed)?.value).toBeCloseTo(57.82, 4);
  });
  test("too small names the block that cut it; without material there is none", () => {
    const thin = programOf({ ...s, diameter: 57.7 });
    const mark = judged(
      sized([{ kind: "diameter", at: -17, nominal: 57.82, upper: 0.01, lower: -0.01 }]),
      thin,
    ).marks.find((m) => m.rule === "size");
    expect(mark).toMatchObject({ passed: false, block: 7 });
    expect(tells([{ kind: "diameter", at: 5, nominal: 57, upper: 9, lower: -99 }])).toEqual(["size"]);
    expect(tells([{ kind: "bore", at: -5, nominal: 0, upper: 0, lower: 0 }])).toEqual([]);
  });
});
