import { describe, expect, test } from "vitest";
import { cycleByNumber } from "../../cycles/index.ts";
import { examples } from "../../examples/index.ts";
import { parse } from "../../nc/parse.ts";
import { print } from "../../nc/program.ts";
import { run } from "../../program/run/run.ts";
import { usualTable } from "../../program/tools/cutting-table.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { simulate } from "../../sim/simulate.ts";
import { report } from "../report.ts";
import type { ChangeSubject } from "./change.ts";
import { betterWays, bestWays, searchOf, type BetterWay } from "./better-ways.ts";
import type { Conditions } from "./situation.ts";

const steel = usualTable.materials.find(({ id }) => id === "c45");
if (!steel) throw new Error("the table lacks its steel");
const conditions: Conditions = {
  tools: shippedTools,
  material: steel,
  isStated: true,
  power: usualTable.power,
  ncLanguage: "en",
};
const attempt = (text: string) => {
  const made = run(parse(text), { tools: conditions.tools, rapid: 10_000 });
  return { run: made, simulation: simulate(made) };
};
const waysOf = (text: string, given: Partial<Conditions> = {}): readonly BetterWay[] => {
  const trial = (tried: string) => {
    const { run: made, simulation } = attempt(tried);
    return { run: made, simulated: () => simulation };
  };
  const search = betterWays(parse(text), attempt(text), trial, { ...conditions, ...given });
  for (;;) {
    const { done, value } = search.next();
    if (done) return value;
  }
};

type Values = Readonly<Record<string, number>>;
/** A cycle with the values of its printed example but for these, and its call from a start point. */
function cut(number: number, start: string, values: Values, before = ""): string {
  const { params = {} } = cycleByNumber(number) ?? {};
  const list = Object.entries(params).map(([q, { example }]) => `${q}=${values[q] ?? example}`);
  return `${before}CYCL DEF ${number} ~\n${list.join(" ~\n")}\nL ${start} FMAX M303\nCYCL CALL\n`;
}
const section = (tool: number, speed: number, ...cuts: readonly string[]) =>
  `TOOL CALL ${tool}\nFUNCTION TURNDATA SPIN VCONST:ON VC:${speed} SMAX3000\nM136\nL X+140 Z+80 R0 FMAX\n${cuts.join("")}L X+140 FMAX\nL Z+80 FMAX\n`;
const program = (sections: readonly string[], { blank = "CYLINDER Z D80 L120 DIST+0", contour = "" } = {}) =>
  `BEGIN PGM A MM\nBLK FORM ${blank}\nFUNCTION MODE TURN\n${sections.join("")}M305\nM30\n${contour}END PGM A MM\n`;

const PLAIN = { Q495: 0, Q501: 0, Q502: 0, Q496: 0, Q503: 0, Q504: 0 };
const shoulder = (d: number, to: number, work: number, more: Values = {}): Values => ({
  ...{ Q215: work, Q491: 80, Q492: 0, Q493: d, Q494: to, ...PLAIN, Q500: 1.2, Q463: 3, Q478: 0.3, Q505: 0.12 },
  ...{ Q483: 0.4, Q484: 0.2, Q506: 0, ...more },
});
const groove = (from: number, to: number, floor: number, more: Values = {}): Values => ({
  ...{ Q215: 0, Q491: 80, Q492: from, Q493: floor, Q494: to, ...PLAIN, Q500: 0.2, Q478: 0.1, Q505: 0.08 },
  ...{ Q483: 0.2, Q484: 0.05, Q488: 0.08, ...more },
});
const rough = (more: Values = {}) => cut(812, "X+80 Z+2", shoulder(70, -40, 1, more));
const finish = (more: Values = {}) => cut(812, "X+84 Z+2", shoulder(70, -40, 2, more));
const FREE = "CYCL DEF 14.0\nCYCL DEF 14.1 CONTOUR LABEL1\n";
const free = { Q499: 0, Q463: 3, Q478: 0.3, Q483: 0, Q484: 0, Q505: 0.12, Q487: 1, Q488: 0.15, Q479: 0, Q506: 0 };
const VALLEY = "LBL 1\nL X+60 Z+0\nL Z-30\nL X+50 Z-45\nL Z-55\nL X+70 Z-65\nL X+80\nLBL 0\n";
const STEPS = "LBL 1\nL X+40 Z+0\nL X+60 Z-30\nL X+74 Z-60\nL X+80\nLBL 0\n";
const DISC = "LBL 1\nL X+12 Z+0\nL Z-3\nL X+80\nLBL 0\n";
const BORE = shoulder(60, -30, 0, { Q491: 40, Q463: 0.5, Q505: 0.08 });
const step = (d: number, i: number) => shoulder(d, -60 + 8 * i, 0, { Q491: d + 4, Q463: 0.5 });
const NEAR = "ROTATION Z DIM_D LBL2";
const OUTLINE = "LBL 2\nL X+0 Z+0\nL X+43\nL X+63 Z-30\nL X+80 Z-66\nL Z-120\nL X+0\nL Z+0\nLBL 0\n";

const SHALLOW = "LBL 1\nL X+78 Z-20\nL X+70 Z-30\nL Z-60\nL X+78 Z-70\nLBL 0\n";
const STEEP = "LBL 1\nL X+80 Z-20\nL X+60 Z-22\nL Z-40\nL X+80 Z-42\nLBL 0\n";
const blade = { ...free, Q463: 1.5, Q478: 0.1, Q505: 0.08, Q488: 0.08, Q507: 0, Q510: 0.8, Q511: 100, Q462: 0 };
/** A bar of 24 mm that stands 120 mm out of its chuck, roughed with an infeed. */
const slender = (infeed: number) =>
  program([section(1, 190, cut(812, "X+24 Z+2", shoulder(16, -100, 1, { Q491: 24, Q463: infeed, Q478: 0.25 })))], {
    blank: "CYLINDER Z D24 L150 DIST+0\n; CLAMPING CHUCK OUTSIDE D24 LENGTH30 FACE-120 SIZE160",
  });

/** Programs with a weakness: the change and the gain that are offered first of their kind. */
const WEAK: readonly (readonly [what: string, text: string, subject: Partial<ChangeSubject>, gain: string])[] = [
  [
    "a finishing cut is called twice",
    program([section(1, 190, rough()), section(3, 240, finish(), finish())]),
    { kind: "noCut", units: [2] },
    "verdict",
  ],
  [
    "two finishing inserts where one would do",
    program([
      section(1, 190, rough(), cut(812, "X+80 Z-38", shoulder(76, -60, 1, { Q492: -40 }))),
      section(3, 240, finish()),
      section(4, 240, cut(812, "X+84 Z-38", shoulder(76, -60, 2, { Q492: -40 }))),
    ]),
    { kind: "fewerTools", units: [2], tools: [4], instead: 3 },
    "tools",
  ],
  [
    "a tool is called twice with another one between",
    program([
      section(1, 190, rough()),
      section(9, 140, cut(842, "X+84 Z-80", groove(-80, -92, 70, { Q463: 1.5, Q507: 0 }))),
      section(1, 190, cut(812, "X+80 Z-38", shoulder(76, -60, 0, { Q492: -40 }))),
    ]),
    { kind: "fewerChanges", tool: 1 },
    "changes",
  ],
  [
    "an insert that does not reach the valley",
    program([section(1, 190, cut(810, "X+80 Z+2", { ...free, Q215: 0 }, FREE))], { contour: VALLEY }),
    { kind: "otherTool", units: [0], tool: 2, instead: 1 },
    "residual",
  ],
  [
    "a wide groove by the narrow blade, with the wider one at hand",
    program([
      section(9, 140, cut(842, "X+82 Z-20", groove(-20, -32, 70, { Q463: 1.5 }))),
      section(
        10,
        140,
        cut(862, "X+82 Z-50", groove(-50, -62, 70, { Q463: 0 })),
        cut(862, "X+82 Z-80", groove(-80, -82.4, 74, { Q463: 0 })),
      ),
    ]),
    { kind: "otherTool", units: [1], tool: 9, instead: 10 },
    "seconds",
  ],
  [
    "a groove turned in passes that takes less time plunged",
    program([section(9, 140, cut(842, "X+82 Z-20", groove(-20, -32, 70, { Q463: 1.5 })))]),
    { kind: "otherCycle", units: [0], cycle: 862 },
    "seconds",
  ],
  [
    "a forging turned as if from the solid",
    program([section(2, 190, cut(810, "X+80 Z+2", { ...free, Q215: 0, Q463: 1 }, FREE))], {
      blank: NEAR,
      contour: STEPS + OUTLINE,
    }),
    { kind: "otherCycle", units: [0], cycle: 815 },
    "seconds",
  ],
  [
    "a shallow valley grooved with an insert at hand",
    program(
      [
        section(1, 190, cut(812, "X+80 Z+2", shoulder(78, -75, 0, { Q463: 1, Q500: 0 }))),
        section(9, 140, cut(840, "X+82 Z-15", blade, FREE)),
      ],
      { contour: SHALLOW },
    ),
    { kind: "otherCycle", units: [1], cycle: 810, instead: 9 },
    "seconds",
  ],
  [
    "a steep valley turned by an insert with a blade at hand",
    program(
      [
        section(9, 140, cut(862, "X+82 Z-80", groove(-80, -84, 74, { Q463: 0 }))),
        section(2, 190, cut(810, "X+82 Z+2", { ...free, Q215: 0 }, FREE)),
      ],
      { contour: STEEP },
    ),
    { kind: "otherCycle", units: [1], tool: 9, instead: 2 },
    "residual",
  ],
  [
    "a groove recessed and then turned for its rest",
    program([
      section(
        9,
        140,
        cut(862, "X+82 Z-20", groove(-20, -40, 64, { Q215: 1, Q463: 0 })),
        cut(842, "X+82 Z-20", groove(-20, -40, 64, { Q463: 1.5 })),
      ),
    ]),
    {
      kind: "both",
      units: [0, 1],
      parts: [
        { kind: "otherCycle", units: [0], cycle: 842, tool: 9, instead: 9 },
        { kind: "noCut", units: [1] },
      ],
    },
    "seconds",
  ],
  [
    "deep passes on a slender workpiece",
    slender(4),
    { kind: "stiffness", units: [0], value: { at: "Q463", from: 4, to: 1.1, most: 1.1 } },
    "bending",
  ],
  [
    "thin passes on a slender workpiece",
    slender(0.5),
    { kind: "infeed", units: [0], value: { at: "Q463", from: 0.5, to: 1, most: 1.1 } },
    "seconds",
  ],
  [
    "thin passes of an insert and of a blade",
    program([
      section(1, 190, rough({ Q463: 1 })),
      section(9, 140, cut(842, "X+82 Z-60", groove(-60, -80, 60, { Q463: 0.5, Q478: 0.12, Q488: 0.12 }))),
    ]),
    { kind: "both", units: [1, 0] },
    "seconds",
  ],
  [
    "thin passes",
    program([section(1, 190, rough({ Q463: 1 })), section(3, 240, finish())]),
    { kind: "infeed", units: [0] },
    "seconds",
  ],
  [
    "a groove that begins high above the stock",
    program([section(9, 140, cut(842, "X+100 Z-20", groove(-20, -32, 70, { Q463: 1.5 })))]),
    { kind: "start", units: [0], value: { at: "X", from: 100, to: 82 } },
    "seconds",
  ],
  [
    "roughing and finishing by one tool in two calls",
    program([section(1, 190, rough()), section(1, 190, finish())]).replaceAll("Z+80", "Z+400"),
    { kind: "oneCall", units: [0, 1] },
    "seconds",
  ],
  [
    "a speed far below that of the material",
    program([section(1, 80, rough()), section(3, 240, finish())]),
    { kind: "cuttingSpeed", units: [0], value: { at: "VC", from: 80, to: 190 } },
    "seconds",
  ],
  [
    "a feed far below that of the material",
    program([section(1, 190, rough({ Q478: 0.12 })), section(3, 240, finish())]),
    { kind: "feed", units: [0], value: { at: "Q478", from: 0.12, to: 0.3 } },
    "seconds",
  ],
  [
    "a groove turned with thin passes of the blade",
    program([section(9, 140, cut(842, "X+82 Z-20", groove(-20, -60, 60, { Q463: 0.5, Q478: 0.12, Q488: 0.12 })))]),
    { kind: "infeed", units: [0], tool: 9 },
    "seconds",
  ],
  [
    "a groove with a feed far below that of its blade",
    program([section(9, 140, cut(842, "X+82 Z-20", groove(-20, -60, 60, { Q463: 1.5, Q478: 0.05 })))]),
    { kind: "feed", units: [0], tool: 9 },
    "seconds",
  ],
  [
    "a bore with thin passes",
    program([section(5, 190, cut(812, "X+40 Z+2", BORE))], { blank: "CYLINDER Z D80 L120 DIST+0 DI40" }),
    { kind: "infeed", units: [0], tool: 5 },
    "seconds",
  ],
  [
    "two operations that have to move together",
    program([
      section(1, 190, rough()),
      section(9, 140, cut(842, "X+84 Z-80", groove(-80, -92, 70, { Q463: 1.5, Q507: 0 }))),
      section(
        1,
        190,
        cut(812, "X+80 Z-38", shoulder(76, -60, 0, { Q492: -40 })),
        cut(812, "X+80 Z-58", shoulder(78, -70, 0, { Q492: -60, Q500: 0 })),
      ),
    ]),
    { kind: "fewerChanges", tool: 1, units: [2, 3, 0] },
    "changes",
  ],
  [
    "thin passes in many operations",
    program([section(1, 190, ...[76, 72, 68, 64, 60].map((d, i) => cut(812, `X+${d + 4} Z+2`, step(d, i))))]),
    { kind: "infeed", units: [0, 1, 2, 3, 4], tool: 1 },
    "seconds",
  ],
  [
    "a disc that is turned along in many short passes",
    program([section(1, 190, cut(810, "X+80 Z+2", { ...free, Q215: 0, Q463: 1.5 }, FREE))], {
      blank: "CYLINDER Z D80 L60 DIST+0",
      contour: DISC,
    }),
    { kind: "otherCycle", units: [0], cycle: 820 },
    "seconds",
  ],
];

const GOOD = import.meta.glob<string>(
  "../../../tests/shop/{boring,bar-parts,circlip-shaft,chamfers,collet-ring,part-off-chamfer}.h",
  { query: "?raw", import: "default", eager: true },
);
const OTHERS: readonly (readonly [string, string])[] = examples
  .filter(({ id }) => id === "flange" || id === "groove" || id === "plate")
  .map(({ id, text }) => [id, text]);

const isFrom = (subject: ChangeSubject, wanted: Partial<ChangeSubject>): boolean =>
  Object.entries(wanted).every(
    ([key, value]) => JSON.stringify(subject[key as keyof ChangeSubject]) === JSON.stringify(value),
  );

/** What a way says, against the report of its program. */
function keepsItsWord(text: string, way: BetterWay): void {
  const [was, is] = [text, way.text].map((each) => {
    const { run: made, simulation } = attempt(each);
    const file = { file: "a.h", run: made, simulation, milliseconds: { parse: 0, plan: 0, simulate: 0 } };
    return { made, told: report(file, "en") };
  });
  if (!was || !is) throw new Error("two programs have two reports");
  expect(print(parse(way.text))).toBe(way.text);
  expect(is.told.time.total).toBeCloseTo(way.after.seconds, 9);
  expect(was.told.time.total).toBeCloseTo(way.before.seconds, 9);
  expect(new Set(is.made.steps.map(({ tool }) => tool.T)).size).toBe(way.after.tools);
  expect(is.told.proof.gouge).toBeLessThanOrEqual(was.told.proof.gouge);
  expect(is.told.proof.rapidInStock).toBeLessThanOrEqual(was.told.proof.rapidInStock);
  if (was.told.proof.verdict === "proved") expect(is.told.proof.verdict).toBe("proved");
  const [wrong, wrongBefore] = [is, was].map(({ told }) => told.issues.filter((i) => i.severity === "error").length);
  expect(wrong).toBeLessThanOrEqual(wrongBefore ?? 0);
  expect(way.after.residual).toBeLessThanOrEqual(way.before.residual + 0.05);
  expect(way.gains).not.toEqual([]);
}

describe("better ways", () => {
  test.each(WEAK)("%s", (_, text, subject, gain) => {
    const ways = waysOf(text);
    const found = ways.find((way) => way.gains.some((each) => each === gain) && isFrom(way.subject, subject));
    expect(found?.subject, JSON.stringify(ways.map((way) => [way.subject, way.gains]))).toMatchObject(subject);
    for (const way of ways) keepsItsWord(text, way);
  });

  test.each(OTHERS)("what is offered for the example %s holds", (_, text) => {
    for (const way of waysOf(text)) keepsItsWord(text, way);
  });

  test.each(Object.entries(GOOD))("%s is good as it is", (_, text) => {
    expect(waysOf(text, { isStated: false }).map(({ subject }) => subject)).toEqual([]);
  });

  test("an operation that cuts nothing because the part came off before is not deleted", () => {
    const part =
      "TOOL CALL 9\nFUNCTION TURNDATA SPIN VCONST:ON VC:140 SMAX2000\nM136\nL X+84 Z-60 FMAX M303\nL X-1 F0.1\nL X+84 FMAX\n";
    const text = program([part, section(1, 190, cut(812, "X+80 Z+2", shoulder(70, -40, 0)))]);
    expect(waysOf(text).filter(({ subject }) => subject.kind === "noCut")).toEqual([]);
  });

  test("without a stated material no speed or feed is offered", () => {
    const text = program([section(1, 80, rough({ Q478: 0.12 })), section(3, 240, finish())]);
    const kinds = waysOf(text, { isStated: false }).map(({ subject }) => subject.kind);
    expect(kinds.filter((kind) => kind === "feed" || kind === "cuttingSpeed")).toEqual([]);
  });

  test("an insert with half the nose radius finishes with the feed of the same roughness", () => {
    const [, text = ""] = WEAK.find(([what]) => what.includes("valley")) ?? [];
    const { candidates } = searchOf(parse(text), attempt(text), conditions);
    const rest = candidates.filter(({ subject }) => subject.kind === "restOperation" && subject.tool === 3);
    // 0.12 · √(0.4 / 0.8) = 0.0849
    expect(rest.map((each) => /Q505=\+?0\.08\b/.test(each.text))).toEqual([true]);
  });

  test("taken one after the other, ways come to an end", () => {
    let [text, taken] = [WEAK[1]?.[1] ?? "", 0];
    for (let [next] = waysOf(text); next && taken < 12; [next] = waysOf(text)) [text, taken] = [next.text, taken + 1];
    expect(taken).toBeGreaterThan(0);
    expect(taken).toBeLessThan(12);
  });

  test("of several ways with one effect the best is offered", () => {
    const measure = { seconds: 10, tools: 1, changes: 0, residual: 0, bending: 0 };
    const way = (text: string, seconds: number): BetterWay => ({
      subject: { kind: "otherTool", units: [0] },
      text,
      before: measure,
      after: { ...measure, seconds },
      gains: ["seconds"],
      worth: 10 - seconds,
    });
    expect(bestWays([way("a", 8), way("b", 6), way("c", 7)]).map(({ text }) => text)).toEqual(["b"]);
  });
});
