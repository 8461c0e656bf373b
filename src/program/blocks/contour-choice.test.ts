import { describe, expect, test } from "vitest";
import { toDiameter } from "../../kernel/units.ts";
import { parse } from "../../nc/parse.ts";
import { filesByName } from "../state/program-files.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";

const head =
  "0 BEGIN PGM T MM\n1 BLK FORM CYLINDER Z D80 L100 DIST+1\n2 FUNCTION MODE TURN\n3 TOOL CALL 15\n4 FUNCTION TURNDATA " +
  "SPIN VCONST:OFF S500\n5 M136\n6 L X+100 Z+50 R0 FMAX M303\n";
const CYCLE =
  "CYCL DEF 820 TURN CONTOUR TRANSV. ~\nQ215=+0 ~\nQ460=+2 ~\nQ499=+0 ~\nQ463=+2 ~\nQ478=+0.3 ~\nQ483=+0 ~\nQ484=+0 ~\n" +
  "Q505=+0.2 ~\nQ487=+1 ~\nQ488=+0 ~\nQ479=+0 ~\nQ480=+0 ~\nQ482=+0 ~\nQ506=+0\nL X+82 Z+3 FMAX\nCYCL CALL";
const FIRST = "L X+80 Z-20.5\nL X+50\nL Z+0";
const SECOND = "L X+76.4 Z-11.3\nL X+41\nL Z+0";
const file = (lines: string) => `BEGIN PGM S MM\n${lines}\nEND PGM S MM\n`;
const FILES = { "FIRST.H": file(FIRST), "SECOND.H": file(SECOND) };
const made = (
  lines: string,
  files: Readonly<Record<string, string>> = {},
  labels = `LBL 1\n${FIRST}\nLBL 0\nLBL "B"\n${SECOND}\nLBL 0`,
) =>
  run(parse(`${head}${lines}\n${CYCLE}\nM30\n${labels}\nEND PGM T MM\n`), {
    tools: shippedTools,
    rapid: 10_000,
    files: filesByName(
      Object.entries({ ...FILES, ...files }).map(([name, text]) => ({ name, text })),
      parse,
    ),
  });
type Made = ReturnType<typeof made>;
const contour = (r: Made) =>
  r.operations[0]?.call?.given.contour?.map((s) => `${+toDiameter(s.to.r).toFixed(3)} ${+s.to.z.toFixed(3)}`);
/** Findings above a notice; unused labels are left out. */
const told = (r: Made) =>
  r.issues
    .filter((f) => f.issue.severity !== "info" && f.issue.code !== "neverReached")
    .map((f) => `${f.issue.code}@${f.block}`);
const [first, second] = [
  ["50 -20.5", "50 0"],
  ["41 -11.3", "41 0"],
];

describe("one contour is run", () => {
  test.each<[string, string, readonly string[]]>([
    ["cycle 14, a number", "CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 KONTURLABEL1", first],
    ["cycle 14, a name", 'CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 CONTOUR LABEL"B"', second],
    ["cycle 14, a text parameter", 'QS1 = "B"\nCYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 CONTOUR LABEL QS1', second],
    ["cycle 14, a number parameter", "Q1 = 3 - 2\nCYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 CONTOUR LABEL Q1", first],
    ["cycle 14, two labels one behind the other", 'CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 LABEL"B" /QS7', second],
    ["CONTOUR DEF", "CONTOUR DEF P1 = LBL 1", first],
    ["CONTOUR DEF on two lines", 'CONTOUR DEF ~\n P1 = "second"', second],
  ])("%s", (name, lines, expected) => {
    const r = made(name.includes("two labels") ? `QS7 = "B"\n${lines}` : lines);
    expect(contour(r)?.slice(0, 2)).toEqual(expected);
    if (!name.includes("two labels")) expect(told(r)).toEqual([]);
  });
  test.each<[string, string, readonly string[]]>([
    ["the only one", 'DECLARE CONTOUR QC1 = "SECOND"', second],
    ["one of its own labels", `DECLARE CONTOUR QC1 = LBL 7 DEPTH5\nLBL 7\n${SECOND}\nLBL 0`, second],
    ["a file whose name a text holds", 'DECLARE STRING QS1 = "SEC" || "OND.H"\nDECLARE CONTOUR QC4 = QS1', second],
    [
      "the one that the formula names",
      'DECLARE CONTOUR QC1 = "FIRST"\nDECLARE CONTOUR QC2 = "SECOND.H"\nQC10 = ( QC2 )',
      second,
    ],
    [
      "through two formulas",
      'DECLARE CONTOUR QC1 = "FIRST"\nDECLARE CONTOUR QC2 = "SECOND.H"\nQC10 = QC1\nQC11 = QC10',
      first,
    ],
  ])("a file of declarations: %s", (_, lines, expected) => {
    const r = made('SEL CONTOUR "ALL"', { "ALL.H": file(lines) });
    expect(told(r)).toEqual([]);
    expect(contour(r)).toEqual(expected);
  });
});

describe("an unverified contour names its block and the reason", () => {
  const joined = (r: Made) => r.issues.filter((f) => f.issue.code === "contoursJoined");
  test("several areas", () => {
    const r = made('Q1 = 0\nCONTOUR DEF P1 = LBL 1 ~\n I2 = "SECOND.H" DEPTH5');
    expect(contour(r)).toBeUndefined();
    expect(joined(r)).toMatchObject([{ block: 8, issue: { data: { cycle: 820, joined: "P1 I2" } } }]);
    expect(r.unproved).toMatchObject([{ what: "CYCL CALL" }]);
  });
  test("a formula", () => {
    const r = made('SEL CONTOUR "ALL"', {
      "ALL.H": file('DECLARE CONTOUR QC1 = "FIRST"\nDECLARE CONTOUR QC2 = LBL 3\n\nQC10 = ( QC1 | QC2 ) \\ QC1'),
    });
    expect(joined(r)).toMatchObject([
      {
        block: 7,
        inFile: { file: "ALL.H", line: 5 },
        issue: { data: { joined: "( QC1 | QC2 ) \\ QC1" } },
      },
    ]);
  });
  test("several without a formula", () => {
    const r = made('SEL CONTOUR "ALL"', {
      "ALL.H": file('DECLARE CONTOUR QC1 = "FIRST"\nDECLARE CONTOUR QC2 = "SECOND"'),
    });
    expect(joined(r)).toMatchObject([{ inFile: { file: "ALL.H", line: 3 }, issue: { data: { joined: "QC1 QC2" } } }]);
  });
  test("a declared file that is missing is named", () => {
    const r = made('SEL CONTOUR "ALL"', { "ALL.H": file('DECLARE CONTOUR QC1 = "GONE.H"') });
    expect(r.issues.find((f) => f.issue.code === "contourInFile")?.issue.data).toEqual({ file: "GONE.H" });
  });
  test("an unknown label leaves the cycle unverified", () => {
    const r = made("FN 18: SYSREAD Q1 = ID1\nCYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 LABEL Q1");
    expect(contour(r)).toBeUndefined();
    expect(r.unproved.map((u) => u.what)).toContain("CYCL CALL");
    expect(r.issues.filter((f) => f.issue.severity === "error")).toEqual([]);
  });
  test("joined contours without a turning cycle are not reported", () => {
    const text = `${head}CONTOUR DEF P1 = LBL 1 I2 = LBL 2\nDECLARE CONTOUR QC1 = "A"\nQC2 = QC1 | QC3\nL X+90 FMAX\nM30\nEND PGM T MM\n`;
    expect(told(run(parse(text), { tools: shippedTools, rapid: 10_000 }))).toEqual([]);
  });
});

describe("FN 14 and the functions that only report", () => {
  const ran = (lines: string) =>
    run(parse(`${head}${lines}\nL X+77.7 FMAX\nM30\nLBL 9\nFN 14: ERROR=+1037\nLBL 0\nEND PGM T MM\n`), {
      tools: shippedTools,
      rapid: 10_000,
    });
  const places = (r: Made) => r.steps.map((s) => +toDiameter(s.move.to.r).toFixed(3));
  test("stops the run where it is met, in a subprogram too", () => {
    const direct = ran("L X+90 FMAX\nFN 14: ERROR = 7");
    expect(places(direct)).toEqual([90]);
    expect(told(direct)).toEqual(["errorRaised@8"]);
    const called = ran("Q1 = 3\nL X+90 FMAX\nIF +Q1 GT +2 GOTO LBL 9");
    expect(places(called)).toEqual([90]);
    expect(called.issues.find((f) => f.issue.code === "errorRaised")?.issue.data).toEqual({ error: 1037 });
  });
  test("has no effect where a jump skips it, and is unverified after an unknown jump", () => {
    expect(told(ran("FN 9: IF +1 EQU +1 GOTO LBL 1\nFN 14: ERROR=7\nLBL 1"))).toEqual([]);
    const unknown = ran("FN 18: SYSREAD Q1 = ID1\nFN 9: IF +Q1 EQU +1 GOTO LBL 1\nFN 14: ERROR=7\nLBL 1");
    expect(places(unknown)).toEqual([77.7]);
    expect(unknown.unproved.map((u) => u.what)).toContain("FN 14");
    expect(unknown.issues.filter((f) => f.issue.severity === "error")).toEqual([]);
  });
  test.each([
    "FN 15: PRINT 5",
    "FN 16: F-PRINT TNC:\\MASK.A / TNC:\\LOG.TXT",
    "FN 19: PLC=+5/+1",
    "FN 20: WAIT FOR I5==0",
    "FN 20: WAIT FOR SYNC",
    "FN 26: TABOPEN TNC:\\TAB1.TAB",
    'FN 27: TABWRITE 5/"RADIUS,DEPTH" = Q5',
    'FN 28: TABREAD Q10 = 6/"X,D"',
    "FN 29: PLC=+10/+5",
    "FN 37: EXPORT QL25",
    'FN 38: SEND /"Q1: %f" / +Q1',
  ])("%s changes neither path nor stock", (block) => {
    const r = ran(block);
    expect(places(r)).toEqual([77.7]);
    expect([told(r), r.unproved]).toEqual([[], []]);
  });
  test("what a table holds is unknown", () => {
    const r = ran('Q10 = 5\nFN 28: TABREAD Q10 = 6/"X,D"\nL X+Q10 FMAX');
    expect(r.unproved.map((u) => u.what)).toEqual(["Q10"]);
  });
});
