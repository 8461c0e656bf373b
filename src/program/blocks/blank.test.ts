import { describe, expect, test } from "vitest";
import { areaOf } from "../../kernel/area/area.ts";
import { toDiameter } from "../../kernel/units.ts";
import { parse } from "../../nc/parse.ts";
import { print } from "../../nc/program.ts";
import { verdictOf } from "../../report/verdict.ts";
import { stockIssues } from "../../sim/issues.ts";
import { simulate } from "../../sim/simulate.ts";
import { stockAt } from "../../sim/stock.ts";
import { traceStock } from "../../sim/tracing.ts";
import { filesByName } from "../state/program-files.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";

/** A shoulder roughed by levels, called from far outside. */
const shoulder = (diameter: number, end: number) => [
  [
    "CYCL DEF 811 SHOULDER",
    "Q215=+1",
    "Q460=+2",
    `Q493=+${diameter}`,
    `Q494=${end}`,
    "Q463=+2.4",
    "Q478=+0.25",
    "Q483=+0.4",
    "Q484=+0.2",
    "Q505=+0.15",
    "Q506=+0",
  ].join(" ~\n"),
  "L X+92.6 Z+3 R0 FMAX M99",
];

const TURN = ["FUNCTION MODE TURN", "TOOL CALL 1", "FUNCTION TURNDATA SPIN VCONST:OFF S700", "M136"];
const made = (blocks: readonly string[], files: Readonly<Record<string, string>> = {}, unit = "MM") => {
  const text = [`BEGIN PGM B ${unit}`, ...blocks, `END PGM B ${unit}`, ""].join("\n");
  const program = parse(text);
  expect(print(program)).toBe(text);
  return run(program, {
    tools: shippedTools,
    rapid: 10_000,
    tracing: traceStock,
    files: filesByName(
      Object.entries(files).map(([name, t]) => ({ name, text: t })),
      parse,
    ),
  });
};
type Made = ReturnType<typeof made>;
const told = (r: Made) => r.issues.map((f) => `${f.issue.code}@${f.line}`);
/** Smallest and largest diameter and Z of a blank. */
const extent = ({ blank }: Pick<Made, "blank">) => {
  const all = blank.flat();
  const [z, x] = [all.map((p) => p.z), all.map((p) => toDiameter(p.r))];
  return [Math.min(...x), Math.max(...x), Math.min(...z), Math.max(...z)].map((n) => Number(n.toFixed(3)));
};

describe("a box that turns", () => {
  const box = ["BLK FORM 0.1 Z X-21.3 Y-28.4 Z-61.7", "BLK FORM 0.2 X+30.9 Y+17.2 Z+1.5"];
  test("is the cylinder around its corners, reported with the diameter that is solid all round", () => {
    const r = made([...box, ...TURN, "M30"]);
    // The corner that is farthest from the axis: 30.9 and 28.4.
    expect(extent(r)).toEqual([0, Number((2 * Math.hypot(30.9, 28.4)).toFixed(3)), -61.7, 1.5]);
    const [issue] = r.issues.filter((f) => f.issue.code === "boxTurned");
    expect([issue?.line, issue?.issue.severity]).toEqual([3, "warning"]);
    expect(issue?.issue.data).toMatchObject({ inner: 34.4 });
  });
  test("whatever the order of its corners, with incremental words, and in inches", () => {
    const turnedRound = made([
      "BLK FORM 0.1 Z X+30.9 Y-28.4 Z+1.5",
      "BLK FORM 0.2 IX-52.2 IY+45.6 IZ-63.2",
      ...TURN,
      "M30",
    ]);
    expect(extent(turnedRound)).toEqual(extent(made([...box, ...TURN, "M30"])));
    const inch = made(["BLK FORM 0.1 Z X-1 Y-1.5 Z-2", "BLK FORM 0.2 X+1 Y+1.5 Z+0", ...TURN, "M30"], {}, "INCH");
    expect(extent(inch)).toEqual([0, Number((50.8 * Math.hypot(1, 1.5)).toFixed(3)), -50.8, 0]);
  });
  test("also in a program section without FUNCTION MODE; while milling it is no turning stock", () => {
    expect(extent(made([...box, ...TURN.slice(1), "M30"]))[1]).toBeGreaterThan(83);
    const milled = made([...box, "FUNCTION MODE MILL", "TOOL CALL 2 Z S2000", "L X+0 Y+0 Z+5 FMAX", "M30"]);
    expect(milled).toMatchObject({
      blank: [],
      cuboid: { left: -21.3, right: 30.9, low: -28.4, high: 17.2, bottom: -61.7, top: 1.5 },
    });
  });
  test.each([
    ["beside the axis", ["BLK FORM 0.1 Z X+0 Y-20 Z-40", "BLK FORM 0.2 X+55 Y+20 Z+0"], ["blankNotTurned@3"]],
    ["without volume", ["BLK FORM 0.1 Z X-20 Y-20 Z-0", "BLK FORM 0.2 X+20 Y+20 Z+0"], ["blankImpossible@3"]],
    ["with one corner", ["BLK FORM 0.1 Z X-20 Y-20 Z-40"], ["notProved@2"]],
    [
      "by a value that nobody knows",
      ["FN 18: SYSREAD Q1 = ID20 NR1", "BLK FORM 0.1 Z X-20 Y-20 Z-40", "BLK FORM 0.2 X+Q1 Y+20 Z+0"],
      ["notUnderstood@2", "notProved@4"],
    ],
  ])("%s is none", (_, blocks, codes) => {
    const r = made([...blocks, ...TURN, "M30"]);
    expect([r.blank, r.cuboid === null]).toEqual([[], _ !== "beside the axis"]);
    expect(told(r)).toEqual(codes);
  });
  test("a rapid through a corner is found, one beside it is none", () => {
    const found = (x: number) =>
      simulate(
        made([...box, ...TURN, "L X+120 Z+3 R0 FMAX", `L X+${x} FMAX`, "L Z-20 FMAX", "L X+120 FMAX", "M30"]),
      ).findings.map((f) => f.kind);
    expect(new Set(found(78.6))).toEqual(new Set(["rapidInStock"]));
    expect(found(84.2)).toEqual([]);
  });
});

const bowl = (name: string, x: number, z: number) => [
  `LBL ${name}`,
  `L X+0 Z+${z}`,
  `L X+${x}`,
  "L Z-47.9",
  "L X+0",
  "LBL 0",
];

describe("other forms", () => {
  test("a rotation is hollow by its inner outline, behind a label or in a file", () => {
    const hollow = [...bowl("3", 62, 0.8), "LBL 4", "L X+22 Z+2", "L Z-19.3", "LBL 0"];
    const r = made(["BLK FORM ROTATION Z DIM_D LBL 3 LBLIN 4", ...TURN, "M30", ...hollow]);
    expect(areaOf(r.blank)).toBeCloseTo(31 * 48.7 - 11 * 20.1, 6);
    expect(told(r)).toEqual(["wordsRecalled@2"]);
    const file = {
      "CAST.H": ["BEGIN PGM CAST MM", "L X+0 Z+0.8", "L X+31", "L Z-47.9", "L X+0", "END PGM CAST MM"].join("\n"),
    };
    expect(areaOf(made(['BLK FORM ROTATION Z DIM_R "TNC:\\CAST.H"', ...TURN, "M30"], file).blank)).toBeCloseTo(
      31 * 48.7,
      6,
    );
    const missing = made(['BLK FORM ROTATION Z DIM_D FILE "GONE.H"', ...TURN, "M30"], file);
    expect([missing.blank, told(missing)]).toEqual([[], ["programNotOpened@2", "notProved@2"]]);
    expect(told(made(['BLK FORM ROTATION Z DIM_D "GONE.H"', "FUNCTION MODE MILL", "M30"], file))).toEqual([
      "programNotOpened@2",
    ]);
    expect(missing.unproved).toMatchObject([{ what: 'BLK FORM ROTATION "GONE.H"', step: 0 }]);
  });
  test("an inner outline that leaves nothing, and an unknown word, are reported", () => {
    expect(told(made(["BLK FORM ROTATION Z DIM_D LBL 3 LBLIN 3", ...TURN, "M30", ...bowl("3", 62, 0.8)]))).toEqual([
      "wordsRecalled@2",
      "blankImpossible@2",
    ]);
    expect(told(made(["BLK FORM ROTATION Z DIM_D LBL 3 TURNED", ...TURN, "M30", ...bowl("3", 62, 0.8)]))).toContain(
      "wordNotUnderstood@2",
    );
  });
  test("a body in a file is named and leaves a turning program unverified, but not a milling program", () => {
    const file = 'BLK FORM FILE "TNC:\\CAD\\BLANK.STL" TARGET "PART.STL"';
    expect(made([file, ...TURN, "M30"]).unproved.map((u) => u.what)).toEqual(['BLK FORM FILE "TNC:\\CAD\\BLANK.STL"']);
    expect(told(made([file, "FUNCTION MODE MILL", "M30"]))).toEqual([]);
    const outlined = made([file, ...TURN, "FUNCTION TURNDATA BLANK LBL 3", "M30", ...bowl("3", 62, 0.8)]);
    expect([told(outlined), extent(outlined)[1]]).toEqual([["blankTraced@7", "blankTaken@7"], 62]);
  });
  test("one round another axis than the spindle is none", () => {
    const r = made(["BLK FORM CYLINDER X D60 L90", ...TURN, "M30"]);
    expect([r.blank, told(r)]).toEqual([[], ["blankNotTurned@2"]]);
  });
  test("a cylinder by radii or diameters, with and without a bore", () => {
    const of = (words: string) => extent(made([`BLK FORM CYLINDER Z ${words}`, ...TURN, "M30"]));
    expect(of("R31.2 L70.3 DIST+2.1 RI8.45")).toEqual([16.9, 62.4, -68.2, 2.1]);
    expect(of("D62.4 L70.3 DIST+2.1 DI16.9")).toEqual(of("R31.2 L70.3 DIST+2.1 RI8.45"));
    expect(of("D62.4 L70.3")).toEqual([0, 62.4, -70.3, 0]);
  });
});

test("the blank of a program that is called counts only where its caller has none", () => {
  const called = (words: string) => ({
    "CUT.H": ["BEGIN PGM CUT MM", words, "L X+90 Z+5 R0 FMAX", "END PGM CUT MM"].join("\n"),
  });
  const box = "BLK FORM 0.1 Z X-10 Y-10 Z-10\nBLK FORM 0.2 X+10 Y+10 Z+0";
  for (const words of ["BLK FORM CYLINDER Z D33 L20", box, 'BLK FORM FILE "A.STL"'])
    expect(extent(made(["BLK FORM CYLINDER Z D62.4 L70.3", ...TURN, "CALL PGM CUT", "M30"], called(words)))).toEqual([
      0, 62.4, -70.3, 0,
    ]);
  expect(extent(made([...TURN, "CALL PGM CUT", "M30"], called("BLK FORM CYLINDER Z D33 L20")))).toEqual([
    0, 33, -20, 0,
  ]);
});

describe("FUNCTION TURNDATA BLANK", () => {
  const bar = "BLK FORM CYLINDER Z D62 L48.7 DIST+0.8";
  const cutting = ["L X+66 Z+3 R0 FMAX M303", "L X+55.4 FMAX", "L Z-20.6 F0.2", "L X+66", "L Z+3 FMAX"];
  const judged = (blocks: readonly string[], ...labels: (readonly string[])[]) => {
    const r = made([bar, ...TURN, ...blocks, "M30", ...labels.flat()]);
    const simulation = simulate(r);
    return { r, simulation, found: stockIssues(simulation).map((i) => i.issue.code), judged: verdictOf(r, simulation) };
  };
  test("before a cut its outline is the blank; one that agrees with BLK FORM is not reported", () => {
    const same = judged(["FUNCTION TURNDATA BLANK LBL 3"], bowl("3", 62, 0.8));
    expect([told(same.r), extent(same.r)]).toEqual([["blankTraced@7"], [0, 62, -47.9, 0.8]]);
  });
  test("material in BLK FORM only is unverified; material in the outline only is reported", () => {
    const less = judged(["FUNCTION TURNDATA BLANK LBL 3"], bowl("3", 57.6, 0.8));
    expect(told(less.r)).toEqual(["blankTraced@7", "blankLacks@7", "notProved@7"]);
    expect(less.r.issues.find((f) => f.issue.code === "blankLacks")?.issue.data).toMatchObject({
      area: expect.closeTo(2.2 * 48.7, 3) as number,
    });
    const more = judged(["FUNCTION TURNDATA BLANK LBL 3"], bowl("3", 62, 3.1));
    expect([told(more.r), more.r.unproved]).toEqual([["blankTraced@7", "blankAdds@7"], []]);
  });
  test("after a cut, cut material stays cut, and everything stays verified", () => {
    const again = judged([...cutting, "FUNCTION TURNDATA BLANK LBL 3"], bowl("3", 62, 0.8));
    expect(again.found).toEqual(["blankGone"]);
    expect(again.simulation.proof.unproved).toEqual([]);
    const plain = judged(cutting);
    expect(areaOf(again.simulation.final)).toBe(areaOf(plain.simulation.final));
    expect(again.simulation.proof.stated[0]?.extraArea).toBeCloseTo(
      areaOf(again.r.blank) - areaOf(plain.simulation.final),
      1,
    );
  });
  test("after a cut, an outline with less material becomes the stock, and the rest is unverified", () => {
    const other = judged(
      [...cutting, "FUNCTION TURNDATA BLANK LBL 3", "L X+59.2 FMAX", "L Z-30.3 F0.2", "L X+66"],
      bowl("3", 60.2, 0.4),
    );
    expect(other.found).toContain("blankLacks");
    expect(other.judged.reasons).toContainEqual({ kind: "unproved", block: 11, what: "FUNCTION TURNDATA BLANK LBL 3" });
    const at = (step: number) => areaOf(stockAt(other.simulation, { step, fraction: 0 }));
    const [statedAt] = other.r.stated.map((s) => s.step);
    // The picture at any step, reached from before or directly, is the stock of the simulation.
    expect(at(statedAt ?? 0)).toBeCloseTo(30.1 * 48.3, 6);
    expect(at(other.r.steps.length)).toBe(areaOf(other.simulation.final));
    expect(areaOf(other.simulation.final)).toBeLessThan(30.1 * 48.3);
    expect(other.simulation.proof.cut).toBeGreaterThan(0);
  });
  test("a part turned end for end is checked per side: residual material from before, gouges by later contours", () => {
    const first = judged(shoulder(51.3, -30.4));
    const other = judged(
      [...shoulder(51.3, -30.4), "L X+80 Z+20 FMAX", "FUNCTION TURNDATA BLANK LBL 3", ...shoulder(33.1, -11.2)],
      bowl("3", 58.2, 0.4),
    );
    const left = (of: typeof first, operation: number) =>
      of.simulation.proof.residual.filter((r) => r.operation === operation).map((r) => r.area);
    expect(left(other, 0)).toEqual(left(first, 0));
    expect(left(other, 1).length).toBeGreaterThan(0);
    expect(other.simulation.proof.gouge).toBe(0);
  });
  test("while it is traced, roughing skips levels that earlier cuts and the outline leave in the air", () => {
    const passes = (before: readonly string[], between: readonly string[] = []) => {
      const { r, simulation } = judged(
        [...before, ...shoulder(51.3, -30.4), ...between, ...shoulder(41.7, -17.9)],
        bowl("3", 62, 0.8),
      );
      return {
        passes: r.operations.map((o) => o.plan.passes),
        air: simulation.proof.airPasses,
        final: areaOf(simulation.final),
        rapidInStock: simulation.proof.rapidInStock,
      };
    };
    const [full, traced] = [passes([]), passes(["FUNCTION TURNDATA BLANK LBL 3"])];
    expect(full.passes).toEqual([9, 11]);
    expect(traced).toMatchObject({ passes: [3, 3], air: 0, rapidInStock: 0 });
    expect(full.air).toBe(14);
    expect(traced.final).toBeCloseTo(full.final, 2);
    for (const end of ["FUNCTION TURNDATA BLANK OFF", "FUNCTION MODE MILL\nFUNCTION MODE TURN\nTOOL CALL 1"])
      expect(passes(["FUNCTION TURNDATA BLANK LBL 3"], [end]).passes).toEqual([3, 11]);
  });
  test("milling traces nothing", () => {
    const r = made([
      bar,
      "FUNCTION MODE MILL",
      "FUNCTION TURNDATA BLANK LBL 3",
      ...TURN,
      "M30",
      ...bowl("3", 57.6, 0.8),
    ]);
    expect([told(r), extent(r)[1]]).toEqual([["notSimulated@4"], 62]);
  });
  test("one in a file is read; OFF says nothing", () => {
    const text = {
      "FORGED.H": ["BEGIN PGM F MM", "L X+0 Z+0.8", "L X+62", "L Z-47.9", "L X+0", "L Z+0.8", "END PGM F MM"].join(
        "\n",
      ),
    };
    const r = made([bar, ...TURN, 'FUNCTION TURNDATA BLANK "FORGED.H"', "FUNCTION TURNDATA BLANK OFF", "M30"], text);
    expect([told(r), extent(r)]).toEqual([["blankTraced@7"], [0, 62, -47.9, 0.8]]);
  });
});
