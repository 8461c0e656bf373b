import { describe, expect, test } from "vitest";
import { areaOf } from "../../kernel/area/area.ts";
import { parse } from "../../nc/parse.ts";
import { print } from "../../nc/program.ts";
import { simulate } from "../../sim/simulate.ts";
import { readTools } from "../tools/read-tools.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";

const table = readTools(
  JSON.stringify({
    tools: [
      { T: 41, NAME: "D17", TYPE: "DRILL", R: 8.5, "T-ANGLE": 90, LCUTS: 43 },
      { T: 42, NAME: "NC90", TYPE: "center", R: 5, "T-ANGLE": 90 },
      { T: 43, NAME: "M8", TYPE: "TAP", R: 4, PITCH: 1.25 },
      { T: 44, NAME: "END10", TYPE: "MILL", R: 5 },
    ],
  }),
);
const mills = "tools" in table ? (table.mills ?? []) : [];

const program = (cycle: string, { tool = 41, at = "X+0", mode = "TURN", behind = "" } = {}) =>
  [
    "BEGIN PGM B MM",
    "BLK FORM CYLINDER Z D63 L71 DIST+1",
    `FUNCTION MODE ${mode}`,
    `TOOL CALL ${tool} Z`,
    "FUNCTION TURNDATA SPIN VCONST:OFF S600",
    "M137",
    `L ${at} Y+0 Z+40 R0 FMAX M3`,
    ...cycle.split("\n"),
    "CYCL CALL",
    behind,
    "M30",
    "END PGM B MM",
    "",
  ].join("\n");
const cycle = (number: number, name: string, q: Readonly<Record<string, number | string>>) =>
  [`CYCL DEF ${number} ${name}`, ...Object.entries(q).map(([key, v]) => `${key}=${v}`)].join(" ~\n");
const made = (text: string) => {
  const read = parse(text);
  expect(print(read)).toBe(text);
  return run(read, { tools: shippedTools, mills, rapid: 10_000 });
};
const moves = (text: string) =>
  made(text).steps.map(
    ({ move: m }) =>
      `${m.kind === "feed" ? (m.dwell ? `rest ${m.dwell}` : `F${m.feed}${m.feedUnit.slice(2)}`) : m.kind}` +
      ` ${+m.to.z.toFixed(3)}`,
  );
const codes = (text: string) =>
  made(text)
    .issues.filter((f) => f.issue.severity !== "info")
    .map((f) => f.issue.code);

const drilling = cycle(200, "DRILLING", {
  Q200: 2,
  Q201: -33,
  Q206: 130,
  Q202: 14,
  Q210: 0.5,
  Q203: 1,
  Q204: 9,
  Q211: 0.25,
});

describe("drilling on the axis while turning", () => {
  test("200: out of the bore between two infeeds, down again to above the last depth", () =>
    expect(moves(program(drilling))).toEqual([
      "rapid 3",
      "F130/min -13",
      "rapid 3",
      "rest 5 3",
      "rapid -11",
      "F130/min -27",
      "rapid 3",
      "rest 5 3",
      "rapid -25",
      "F130/min -32",
      "rest 2.5 -32",
      "rapid 3",
      "rapid 10",
    ]));
  test("the bore has the shape of the drill, nothing is left unproved", () => {
    const done = made(program(drilling));
    expect(done.unproved).toEqual([]);
    const { final, proof } = simulate(done);
    // A cylinder of 33 mm and a point of 45° of 8.5 mm, whose last 8.5 mm are half as much.
    expect(areaOf(done.blank) - areaOf(final)).toBeCloseTo(8.5 * (33 - 8.5) + (8.5 * 8.5) / 2, 1);
    expect(proof.rapidInStock).toBe(0);
    expect(proof.gouge).toBe(0);
  });
  test("Q395 = 1 drives the full radius to the depth", () =>
    expect(moves(program(drilling.replace("Q202=14", "Q202=0") + " ~\nQ395=1"))[1]).toBe("F130/min -40.5"));
  test("203: chips broken inside twice, then out; smaller infeeds down to the least", () =>
    expect(
      moves(
        program(
          cycle(203, "UNIVERSAL DRILLING", {
            Q200: 2,
            Q201: -20,
            Q206: 90,
            Q202: 7,
            Q203: 0,
            Q212: 3,
            Q213: 1,
            Q205: 3,
            Q208: 500,
            Q256: 0.3,
          }),
        ),
      ),
    ).toEqual([
      "rapid 2",
      "F90/min -7",
      "rapid -6.7",
      "F90/min -11",
      "F500/min 2",
      "rapid -9",
      "F90/min -14",
      "rapid -13.7",
      "F90/min -17",
      "F500/min 2",
      "rapid -15",
      "F90/min -20",
      "F500/min 2",
    ]));
  test("205: from a start that lies deeper, chips broken every Q257", () =>
    expect(
      moves(
        program(
          cycle(205, "UNIVERSAL PECKING", {
            Q200: 1,
            Q201: -30,
            Q206: 90,
            Q202: 12,
            Q203: 0,
            Q257: 5,
            Q256: 0.5,
            Q258: 0.4,
            Q259: 0.4,
            Q379: 10,
            Q253: 700,
            Q208: 0,
          }),
        ),
      ),
    ).toEqual([
      "rapid 1",
      "F700/min -9",
      "F90/min -15",
      "rapid -14.5",
      "F90/min -20",
      "rapid -19.5",
      "F90/min -22",
      "rapid 1",
      "rapid -21.6",
      "F90/min -27",
      "rapid -26.5",
      "F90/min -30",
      "F90/min 1",
    ]));
  test("201 and 240: to the depth, back at rapid or at the retraction feed", () => {
    const reaming = { Q200: 2, Q201: -12.5, Q206: 60, Q211: 0, Q208: "MAX", Q203: 0, Q204: 2 };
    expect(moves(program(cycle(201, "REAMING", reaming)))).toEqual(["rapid 2", "F60/min -12.5", "rapid 2"]);
    const centering = { Q200: 2, Q343: 1, Q201: 0, Q344: -7, Q206: 60, Q211: 0, Q203: 0, Q204: 2 };
    expect(moves(program(cycle(240, "CENTERING", centering), { tool: 42 }))).toEqual([
      "rapid 2",
      "F60/min -3.5",
      "rapid 2",
    ]);
  });
  test("207 and 209: the pitch in one turn, down and back", () => {
    const tap = { Q200: 5, Q201: -16, Q239: 1.25, Q203: 0, Q204: 5 };
    expect(moves(program(cycle(207, "RIGID TAPPING NEW", tap), { tool: 43 }))).toEqual([
      "rapid 5",
      "F1.25/rev -16",
      "F1.25/rev 5",
    ]);
    expect(moves(program(cycle(209, "TAPPING W/ CHIP BRKG", { ...tap, Q257: 9, Q256: 1 }), { tool: 43 }))).toEqual([
      "rapid 5",
      "F1.25/rev -9",
      "F1.25/rev -7.75",
      "F1.25/rev -16",
      "F1.25/rev 5",
    ]);
    expect(codes(program(cycle(207, "RIGID TAPPING NEW", { ...tap, Q239: 1.5 }), { tool: 43 }))).toEqual([
      "pitchOfTap",
    ]);
  });
  test("the tool stands above the bore behind it, and a boring bar starts in it", () => {
    const done = made(program(drilling, { behind: "L X+7 F100\nL Z-5 FMAX" }));
    expect(done.steps.at(-2)?.from.z).toBe(10);
    expect(done.unproved).toEqual([]);
  });
  test("a bore deeper than the cutting edge length is reported", () => {
    expect(codes(program(drilling))).toEqual([]);
    expect(codes(program(drilling.replace("Q201=-33", "Q201=-43.5")))).toEqual(["drillTooShort"]);
    expect(codes(program(drilling.replace("Q206=130", "Q206=0")))).toEqual(["feedZero"]);
  });
  test("a bore less deep than the point of its drill is reported, and none that only centres", () => {
    expect(codes(program(drilling.replace("Q201=-33", "Q201=-8.5")))).toEqual([]);
    expect(codes(program(drilling.replace("Q201=-33", "Q201=-8")))).toEqual(["pointBeyondDepth"]);
    expect(codes(program(drilling.replace("Q201=-33", "Q201=-2"), { tool: 42 }))).toEqual([]);
  });
  test.each([
    ["M3", "+1.25", []],
    ["M4", "-1.25", []],
    ["M4", "+1.25", ["hand"]],
    ["M3", "-1.25", ["hand"]],
    ["M5", "+1.25", ["stopped"]],
  ])("%s and a pitch of %s: the sign is the hand of the thread", (start, pitch, how) => {
    const tapping = cycle(207, "RIGID TAPPING", { Q200: 5, Q201: -12, Q239: pitch, Q203: 0, Q204: 20 });
    const done = run(parse(program(tapping, { tool: 43 }).replace(" M3\n", ` ${start}\n`)), {
      tools: shippedTools,
      mills,
      rapid: 10_000,
    });
    expect(done.issues.flatMap(({ issue }) => (issue.code === "spindleStopped" ? [issue.data.how] : []))).toEqual(how);
  });
  test("a cycle without a call is reported", () => {
    const text = program(drilling);
    expect(codes(text.replace("CYCL CALL\n", ""))).toEqual(["cycleNeverCalled"]);
  });
  test("the datum counts", () => expect(moves(program(`TRANS DATUM AXIS Z-4\n${drilling}`))[0]).toBe("rapid -1"));
  test.each([
    ["off the axis", drilling, { at: "X+0.5" }],
    ["with a milling cutter or a turning tool", drilling, { tool: 1 }],
    ["while milling", drilling, { mode: "MILL" }],
    ["with an infeed nobody means", drilling.replace("Q202=14", "Q202=0.001"), {}],
    ["upwards", drilling.replace("Q201=-33", "Q201=+33"), {}],
    ["without its depth", drilling.replace("Q201=-33 ~\n", ""), {}],
    ["another cycle", drilling.replace("200", "208"), {}],
  ])("unverified %s", (_, text, where) => {
    const done = made(program(text, where));
    expect(done.steps.filter((s) => s.move.kind !== "rapid")).toEqual([]);
    expect(done.unproved).toHaveLength(1);
    expect(done.unproved[0]?.what).toMatch(/^CYCL DEF 20/);
  });
});
