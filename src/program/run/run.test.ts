import { describe, expect, test } from "vitest";
import { toDiameter } from "../../kernel/units.ts";
import { parse } from "../../nc/parse.ts";
import { run } from "./run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";

const head =
  "0 BEGIN PGM T MM\n1 BLK FORM CYLINDER Z D80 L100 DIST+1 DI20\n2 FUNCTION MODE TURN\n3 TOOL CALL 1\n4 FUNCTION TURNDATA " +
  "SPIN VCONST:OFF S500\n5 M136\n6 L X+100 Z+50 R0 FMAX\n";
const runText = (text: string) => run(parse(text), { tools: shippedTools, rapid: 10_000 });
const body = (lines: string, unit = "MM") =>
  runText(
    `${head.replace(" MM", ` ${unit}`)}${lines
      .trim()
      .split("\n")
      .map((l) => l.trim())
      .join("\n")}\nM30\nEND PGM T ${unit}\n`,
  );
const path = (lines: string, unit?: string) =>
  body(lines, unit).steps.map(
    (s) =>
      `${s.move.kind} ${+toDiameter(s.move.to.r).toFixed(3)} ${+s.move.to.z.toFixed(3)}` +
      ("feed" in s.move ? ` F${+s.move.feed.toFixed(4)}${s.move.feedUnit.slice(2)}` : ""),
  );
const codes = (lines: string) =>
  body(lines)
    .issues.filter((f) => f.issue.severity !== "info")
    .map((f) => `${f.issue.code}${"at" in f.issue && f.issue.at ? ` ${f.issue.at}` : ""}`);

describe("motion outside cycles", () => {
  test("FMAX counts for its block, F stays", () =>
    expect(path("L X+80 Z+2 FMAX\nL Z-10 F0.2\nL X+90\nL Z+2 FMAX\nL X+80")).toEqual([
      "rapid 80 2",
      "feed 80 -10 F0.2/rev",
      "feed 90 -10 F0.2/rev",
      "rapid 90 2",
      "feed 80 2 F0.2/rev",
    ]));
  test("incremental words, X as a diameter", () => expect(path("L IX-20 IZ-48 FMAX")).toEqual(["rapid 80 2"]));
  test("M137 goes back to mm/min", () => expect(path("M137\nL Z+10 F100")).toEqual(["feed 100 10 F100/min"]));
  test("arcs by radius, by centre and tangential", () =>
    expect(path("L X+50 Z+0 F0.2\nCR X+60 Z-5 R+5 DR-\nCC X+60 Z-10\nC X+50 Z-10 DR+\nL Z-20\nCT X+60 Z-25")).toEqual([
      "feed 50 0 F0.2/rev",
      "arc 60 -5 F0.2/rev",
      "arc 50 -10 F0.2/rev",
      "feed 50 -20 F0.2/rev",
      "arc 60 -25 F0.2/rev",
    ]));
  test("polar words count from +Z towards +X, PR is a true length", () =>
    expect(path("CC X+40 Z+0\nLP PR+10 PA+90 FMAX\nLP IPA-90")).toEqual(["rapid 60 0", "feed 40 10 F0/rev"]));
  test("chamfer and rounding between path blocks, with a feed of their own", () =>
    expect(path("L X+50 Z+0 F0.2\nL Z-20\nCHF 2 F0.1\nL X+60\nRND R1\nL Z-40")).toEqual([
      "feed 50 0 F0.2/rev",
      "feed 50 -18 F0.2/rev",
      "feed 54 -20 F0.1/rev",
      "feed 58 -20 F0.2/rev",
      "arc 60 -21 F0.2/rev",
      "feed 60 -40 F0.2/rev",
    ]));
  test("an inch program moves in millimetres", () =>
    expect(path("L X+1 Z+0.1 F0.01", "INCH")).toEqual(["feed 25.4 2.54 F0.254/rev"]));
  test("after a tool change the position is unknown", () => {
    // The first is the last position of the previous tool.
    expect(path("TOOL CALL 2\nL Z+10 FMAX\nL X+90 FMAX\nL Z+5 FMAX")).toEqual(["rapid 100 50", "rapid 90 5"]);
    expect(codes("TOOL CALL 99\nL X+5 FMAX")).toEqual(["toolUnknown tool"]);
  });
  test("faults are reported at their block and the rest runs", () => {
    expect(codes("L Z+10")).toEqual(["feedMissing"]);
    expect(codes("RND R2\nL Z+5 FMAX")).toContain("cornerElementAlone contour");
    expect(codes("C X+10 Z+0 DR+ F1")).toEqual(["poleMissing"]);
    expect(codes("CR X+10 Z+0 R+1 DR+ F1")).toEqual(["arcImpossible"]);
    expect(codes("LP PR+1 PA+1 FMAX")).toEqual(["poleMissing"]);
  });
});

describe("parameters, labels and calls", () => {
  test("assignments and sums", () =>
    expect(
      path(
        "Q1 = 2 * ( 3 + 4 ) - 4\nFN 1: Q2 =+Q1 + +5\nFN 5: Q3 = SQRT 16\nQL4 = SIN 30\nL X+Q1 Z-Q2 FMAX\nL X+Q3 Z+QL4 FMAX",
      ),
    ).toEqual(["rapid 10 -15", "rapid 4 0.5"]));
  test("an unset parameter and a division by zero are errors", () =>
    expect(codes("L X+Q77 FMAX\nFN 4: Q1 = 5 DIV 0")).toEqual(["parameterUnset Q77", "divisionByZero"]));
  test("REP repeats the blocks since the label", () =>
    expect(path("L Z+0 FMAX\nLBL 1\nL IZ-1 FMAX\nCALL LBL 1 REP 3\nL Z+50 FMAX")).toEqual([
      "rapid 100 0",
      "rapid 100 -1",
      "rapid 100 -2",
      "rapid 100 -3",
      "rapid 100 -4",
      "rapid 100 50",
    ]));
  test("a subprogram behind M30 returns", () =>
    expect(path('CALL LBL "DOWN"\nL Z+0 FMAX\nCALL LBL "DOWN"\nM30\nLBL "DOWN"\nL IZ-10 FMAX\nLBL 0')).toEqual([
      "rapid 100 40",
      "rapid 100 0",
      "rapid 100 -10",
    ]));
  test("endless programs end", () => {
    expect(codes("LBL 1\nCALL LBL 1\nLBL 0")).toEqual(["callsTooDeep"]);
    expect(codes("LBL 1\nLBL 2\nCALL LBL 2 REP 65534\nCALL LBL 1 REP 65534")).toEqual(["tooManyRepeated"]);
    expect(codes("LBL 2\nLBL 1\nL IX+1 FMAX\nL IX-1 FMAX\nCALL LBL 1 REP 65534\nCALL LBL 2 REP 65534").at(-1)).toMatch(
      /^tooMany/,
    );
    expect(codes("CALL LBL 7")).toEqual(["labelMissing"]);
  });
  test("a run that stops at a bound leaves the rest unproved, from the step it stopped at", () => {
    const loop = body("LBL 1\nL IX+1 FMAX\nCALL LBL 1 REP 999999");
    expect(loop.unproved).toEqual([{ step: loop.steps.length, block: expect.any(Number), what: expect.any(String) }]);
    expect(loop.steps.length).toBeGreaterThan(60_000);
    const contour = body(`BLK FORM ROTATION Z DIM_D LBL 5\nM30\nLBL 5\n${"L IX+0.001 Z+0\n".repeat(20_001)}LBL 0`);
    expect(contour.issues.map((f) => f.issue.code)).toContain("contourTooLong");
    expect(contour.issues.map((f) => f.issue.code)).not.toContain("labelNotClosed");
    expect(contour.unproved.length).toBe(1);
  });
  test("milling and turning share one bound of moves, and milling never drops a move in silence", () => {
    const milled = body(
      "FUNCTION MODE MILL\nLBL 1\nLBL 2\nL IX+1 IY+1 F100\nL IX-1\nL IY-1\nL IX+1\nL IX-1\nCALL LBL 2 REP 65534\nCALL LBL 1 REP 65534",
    );
    expect(milled.issues.map((f) => f.issue.code).filter((c) => c.startsWith("tooMany")).length).toBe(1);
    expect(milled.unproved.length).toBe(1);
  });
});

describe("blank", () => {
  test("a cylinder with a bore, in diameters", () =>
    expect(body("").blank).toEqual([
      [
        { z: -99, r: 10 },
        { z: 1, r: 10 },
        { z: 1, r: 40 },
        { z: -99, r: 40 },
      ],
    ]));
  test("an outline in a label, in radii or diameters, reaches down to the axis", () => {
    const outline = (measure: string, x: number) =>
      body(`BLK FORM ROTATION Z DIM_${measure} LBL 5\nM30\nLBL 5\nL X+${x} Z+0\nL Z-50\nLBL 0`).blank.flat();
    expect(Math.max(...outline("D", 60).map((p) => p.r))).toBe(30);
    expect(outline("R", 30)).toEqual(outline("D", 60));
    expect(Math.min(...outline("D", 60).map((p) => p.r))).toBe(0);
  });
  test("an impossible cylinder is an error", () =>
    expect(codes("BLK FORM CYLINDER Z D20 L50 DI30")).toEqual(["blankImpossible"]));
});

const cycle = (number: number, values: string) => `CYCL DEF ${number} NAME ~\n${values.trim().split(" ").join(" ~\n")}`;
const shoulder =
  "Q215=+0 Q460=+2 Q491=+75 Q492=+0 Q493=+50 Q494=-55 Q495=+5 Q501=+1 Q502=+0.5 Q500=+1.5 Q496=+0 Q503=+1 Q504=+0.5 Q463=+3 " +
  "Q478=+0.3 Q483=+0.4 Q484=+0.2 Q505=+0.2 Q506=+0";

describe("cycles", () => {
  test("CYCL CALL and M99 execute the definition", () => {
    const called = body(`${cycle(812, shoulder)}\nL X+75 Z+2 FMAX\nCYCL CALL`);
    const m99 = body(`${cycle(812, shoulder)}\nL X+75 Z+2 FMAX M99`);
    expect(called.operations).toHaveLength(1);
    expect(m99.operations[0]?.plan).toEqual(called.operations[0]?.plan);
    const [o] = called.operations;
    expect(called.steps.slice(o?.firstStep, (o?.lastStep ?? 0) + 1).every((s) => s.operation === 0)).toBe(true);
    expect(called.steps[(o?.lastStep ?? 0) + 1]).toBeUndefined();
  });
  test("a missing parameter is reported on the line of its definition, an unusual value at its Q", () => {
    const without = body(`${cycle(812, shoulder.replace("Q493=+50 ", ""))}\nL X+75 Z+2 FMAX\nCYCL CALL`);
    expect(without.issues.find((f) => f.issue.code === "missing")).toMatchObject({
      issue: { at: "Q493" },
      line: 8,
      operation: 0,
    });
    const wrong = body(`${cycle(812, shoulder.replace("Q215=+0", "Q215=+7"))}\nL X+75 Z+2 FMAX\nCYCL CALL`);
    expect(wrong.issues.find((f) => f.issue.code === "notAChoice")).toMatchObject({ issue: { at: "Q215" }, line: 9 });
    expect(wrong.operations[0]?.plan.moves).toEqual([]);
  });
  test("an optional parameter may be missing", () =>
    expect(codes(`${cycle(812, shoulder.replace("Q500=+1.5 ", ""))}\nL X+75 Z+2 FMAX\nCYCL CALL`)).not.toContain(
      "missing Q500",
    ));
  test("values from parameters, as they were at the definition", () =>
    expect(
      body(
        `Q9 = 49\n${cycle(812, shoulder.replace("Q493=+50", "Q493=+Q9"))}\nQ9 = 1\nL X+75 Z+2 FMAX\nCYCL CALL`,
      ).operations[0]?.plan.contour.some((s) => toDiameter(s.to.r) < 50),
    ).toBe(true));
  test("an unknown cycle is reported, and the rest runs", () => {
    const found = body("CYCL DEF 208 BORE MILLING ~\nQ200=+2\nL X+75 Z+2 FMAX\nCYCL CALL\nL Z+5 FMAX");
    expect(found.issues.map((f) => f.issue.code)).toContain("cycleNotSimulated");
    expect(found.steps).toHaveLength(2);
  });
  test("a free contour needs its label", () => {
    const free =
      "Q215=+0 Q460=+2 Q499=+0 Q463=+3 Q478=+0.3 Q483=+0.4 Q484=+0.2 Q505=+0.2 Q487=+1 Q488=+0 Q479=+0 Q480=+0 Q482=+0 Q506=+0";
    const end =
      "\nL X+75 Z+2 FMAX\nCYCL CALL\nM30\nLBL 2\nL X+75 Z-20\nL X+50\nRND R2\nL X+20 Z-25\nRND R2\nL Z+0\nLBL 0";
    expect(codes(cycle(820, free) + end)).toContain("contourNotNamed");
    const named = (text: string) => body(`CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 ${text}\n${cycle(820, free)}${end}`);
    expect(named("LABEL CONTOUR2").operations[0]?.plan.contour).toHaveLength(5);
    expect(named("KONTURLABEL3").issues.map((f) => f.issue.code)).toContain("labelMissing");
    const long = body(
      `CYCL DEF 14.0 KONTUR\nCYCL DEF 14.1 KONTURLABEL2\n${cycle(820, free)}${end.replace("RND R2", "RND R250")}`,
    );
    const row =
      `${head}CYCL DEF 14.0 KONTUR\nCYCL DEF 14.1 KONTURLABEL2\n${cycle(820, free)}${end}`
        .split("\n")
        .indexOf("RND R2") + 1;
    expect(long.issues.find((f) => f.issue.code === "cornerElementTooLong")).toMatchObject({ line: row, operation: 0 });
  });
  test("a call without definition, tool or turning mode is an error", () => {
    expect(codes("CYCL CALL")).toContain("noCycleDefined");
    expect(codes(`FUNCTION MODE MILL\n${cycle(812, shoulder)}\nCYCL CALL`)).toContain("notInTurnMode");
    expect(runText(`1 ${cycle(812, shoulder)}\n2 CYCL CALL\n`).issues.map((f) => f.issue.code)).toContain(
      "noToolCalled",
    );
  });
});
