import { describe, expect, test } from "vitest";
import { parse } from "./parse.ts";
import { issuesOf, print, startLines } from "./program.ts";

const one = (text: string) => parse(text).blocks[0];
const findingsOf = (text: string) =>
  issuesOf(parse(`0 BEGIN PGM A MM\n${text}\n9 END PGM A MM\n`))
    .filter((i) => i.code !== "blockNumber" && i.code !== "blockNumberMissing")
    .map((i) => `${i.code} ${i.line}:${i.column}`);

describe("blocks", () => {
  test("number, skip mark, comment", () => {
    expect(one("/12 L X+1 ;go")).toMatchObject({ number: 12, skip: true, comment: "go" });
    expect(one("12 / L X+1")).toMatchObject({ number: 12, skip: true });
    expect(one('3 LBL "A;B" ;c')).toMatchObject({ statement: { kind: "label", label: "A;B" }, comment: "c" });
  });
  test("a cycle keeps its lines together, with and without ~, also wrapped ones", () => {
    const lines = (text: string) => parse(text).blocks.map((b) => b.lines);
    expect(lines("1 CYCL DEF 7 N ~\nQ1=1 ~\nQ2=2\n2 M3\n")).toEqual([3, 1]);
    expect(lines("1 CYCL DEF 7 N\nQ1=1 ;A\n\nQ2 =2\n2 M3\n")).toEqual([4, 1]);
    expect(lines("1 CYCL DEF 7  LONG\nNAME\nQ1=1 ;A\nLABEL\nQ2=2\n2 M3")).toEqual([5, 1]);
    expect(one("1 CYCL DEF 7  LONG\nNAME\nQ1=1 ;A\nLABEL\nQ2=2\n")?.statement).toMatchObject({
      name: "LONG NAME",
      parameters: [{ label: "A LABEL" }, { label: null }],
    });
    expect(lines("CYCL DEF 7 N\nQ5 = 3\nL X+1")).toEqual([1, 1, 1]);
    expect(lines("CYCL DEF 207 N ~\nQ200=+2 ~\nQ201=-5\nQ1999 = 25\nL X+1")).toEqual([3, 1, 1]);
    expect(lines("CYCL DEF 207 N ~\nQ200=+2\nQ201=-5\nL X+1")).toEqual([3, 1]);
  });
  test("a continuation mark before a new block is reported and ignored", () => {
    expect(parse("1 CYCL DEF 7 N ~\nQ1=1 ~\n2 M3\n").blocks).toHaveLength(2);
    expect(findingsOf("1 CYCL DEF 7 N ~\nQ1=1 ~\n2 M3")).toEqual(["continuationOpen 3:7"]);
  });
  test("line positions are correct for any line end", () =>
    expect(startLines(parse("1 M3\r\n2 CYCL DEF 7 N ~\rQ1=1\n3 M4"))).toEqual([1, 2, 4]));
});

describe("spellings of posts and of older controls", () => {
  test.each([
    ["CYCLDEF 9.0 DWELL", { kind: "cycleLine", cycle: 9, line: 0, text: "DWELL" }],
    ["CYCL DEF9 .1 DWELL 2.5", { kind: "cycleLine", cycle: 9, line: 1, text: "DWELL 2.5" }],
    ["CYCLE DEF 7.1 X-3.7", { kind: "cycleLine", cycle: 7, line: 1, text: "X-3.7" }],
    ["CYCLE CALL M3", { kind: "cycleCall", how: "" }],
    ["N40 L X+1.5 FMAX", { kind: "path", path: "L" }],
    ["n45 CYCL DEF 17.0 RIGID TAPPING GS", { kind: "cycleLine", cycle: 17, line: 0 }],
  ])("%s", (text, statement) => {
    expect(one(text)?.statement).toMatchObject(statement);
    expect(print(parse(text))).toBe(text);
  });
  test("the blocks of a free contour", () => {
    expect(one("7 FLT AN+33.5 LEN 12 R0 F200")?.statement).toMatchObject({
      kind: "free",
      form: "FLT",
      given: [{ name: "AN", value: 33.5 }],
      words: { length: 12, compensation: "R0" },
    });
    expect(one("FC DR- R15.5 CCX+2 CCY-Q4")?.statement).toMatchObject({
      form: "FC",
      given: [
        { name: "CCX", value: 2 },
        { name: "CCY", value: { parameter: "Q4", negative: true } },
      ],
      words: { radius: 15.5, turn: "cw" },
    });
    expect(one("FSELECT2")?.statement).toMatchObject({ form: "FSELECT", given: [{ value: 2 }] });
    expect(one("FSELECT")?.statement.kind).toBe("unknown");
    const far = "7 FC IX+4 DR- R10 CLSD- P1X+4 P1Y-Q3 PDX+1 PDY+2 D3.5 ICCX+2 ICCY-1 RCCX5 RX12 IAN+20 RAN13 F200";
    expect(one(far)?.statement).toMatchObject({
      words: { axes: [{ axis: "X", incremental: true }], radius: 10 },
      given: { length: 12 },
    });
    expect(findingsOf(far)).toEqual([]);
    expect(findingsOf("1 FL X+1 P4X+4")).toEqual(["wordNotUnderstood 2:10"]);
  });
  test("an N number is a block number, and begins a block", () => {
    expect(one("/N12 L X+1")).toMatchObject({ number: 12, skip: true });
    expect(parse("N10 CYCLE DEF 200 D ~\nQ200=2 ~\nQ201=-5\nN20 M3\n").blocks.map((b) => [b.number, b.lines])).toEqual([
      [10, 3],
      [20, 1],
    ]);
    expect(one("NOTE 1")).toMatchObject({ number: null, statement: { kind: "unknown" } });
    expect(one("N10.5 L X+1")).toMatchObject({ number: null, statement: { kind: "unknown" } });
  });
});

describe("findings have a place, and a fix where it is obvious", () => {
  test.each([
    ["1 L X+1 FOO", "wordNotUnderstood 2:9"],
    ["1 L X+1 X+2", "wordTwice 2:9"],
    ["1 PLANET RESET", "notUnderstood 2:3"],
    ["1 CYCL DEF 7 N ~\nQ1=abc", "badNumber 3:4"],
    ["1 CYCL DEF 7 N ~\nQ1=", "wordMissing 3:4"],
    ["1 CYCL DEF 7 N ~\nQ491+5 ;A", "equalsMissing 3:1"],
    ["1 CYCL DEF 7 N ~\nQ491 =+5 ;A", "blankBeforeEquals 3:1"],
    ["1 CR X+1 DR+", "wordMissing 2:3"],
    [`1 FC D${"9".repeat(400)}`, "badNumber 2:7"],
  ])("%j", (text, finding) => expect(findingsOf(text)).toEqual([finding]));
  test("the fix of a misprint removes it", () => {
    for (const text of ["1 CYCL DEF 7 N ~\nQ491+5 ;A\n", "1 CYCL DEF 7 N ~\nQ491 =+5 ;A\n"]) {
      const fix = issuesOf(parse(text)).find((i) => i.fix)?.fix;
      if (!fix) throw new Error("no fix");
      expect(text.slice(0, fix.offset) + fix.text + text.slice(fix.offset + fix.length)).toBe(
        "1 CYCL DEF 7 N ~\nQ491=+5 ;A\n",
      );
    }
  });
  test("numbers out of order, missing ones", () => {
    expect(issuesOf(parse("0 BEGIN PGM A MM\n3 M3\nM4\n4 END PGM A MM")).map((i) => i.code)).toEqual([
      "blockNumber",
      "blockNumberMissing",
    ]);
    expect(issuesOf(parse("M3\n")).map((i) => i.code)).toEqual(["frameMissing", "frameMissing"]);
  });
  test("a DIN/ISO program is refused as such, once; a single such block in Klartext is a finding of that block", () => {
    const errors = (text: string) =>
      issuesOf(parse(text))
        .filter((i) => i.severity === "error")
        .map((i) => `${i.code}@${i.line}`);
    expect(errors("%SHAFT G71 *\nN10 G30 G17 X+0 Y+0 Z-40 *\nN20 G812 Q215=+0 *\nN99999 %SHAFT G71 *\n")).toEqual([
      "isoProgram@1",
    ]);
    expect(errors("N10 G01 X+20 Z-5 F0.2\nN20 G79\n")).toEqual(["isoProgram@1"]);
    expect(errors("0 BEGIN PGM A MM\n1 G812 Q215=+0\n2 END PGM A MM\n")).toEqual([]);
    expect(errors("L X+5 Z-3 FMAX\nGRV RADIAL POS-20 BREADTH5 DEPTH3\n")).toEqual([]);
  });
});

describe("spellings", () => {
  test.each([
    ["L X +75,5 R 0 F MAX", "L X+75.5 R0 FMAX"],
    ["apr lt", "APR LT"],
    ["APPR LT X+1 LEN 15", "APPR LT X+1 LEN15"],
    ["FN0:Q5=+60", "FN 0: Q5 = +60"],
    ["CALL LBL 2 REP8", "CALL LBL 2 REP 8"],
    ["TOOL  CALL 5 Z S3000 F MAX", "TOOL CALL 5 Z S3000 FMAX"],
    ["l x+1", "L X+1"],
    ["L X+30 R F M", "L X+30"],
    ["L Z+2,5 R F9999 M", "L Z+2.5 F9999"],
    ["C X+5 Y+6 DR- R F MAX M", "C X+5 Y+6 DR- FMAX"],
    ["STOP M", "STOP"],
    ["C+90 R0 FMAX", "L C+90 R0 FMAX"],
    ["CYCL CALL M", "CYCL CALL"],
    ["trans  rotation rot12,5", "TRANS ROTATION ROT+12.5"],
  ])("%s is %s", (one1, other) => {
    const [a, b] = [one(one1)?.statement, one(other)?.statement];
    if (a?.kind === "unknown") expect(b?.kind).toBe("unknown");
    else expect(a).toEqual(b);
  });
  test.each([
    "CC",
    "L",
    "L R F M",
    "M140 MB MAX",
    "CYCL CALL POS X+1",
    "BLK FORM CYLINDER Z R50 L105 DIST+5 RI10",
    'FUNCTION TURNDATA BLANK "f.h"',
    "FUNCTION TURNDATA CORR-TCS:Z/X DZL:0.1 DXL:0.05",
    "CT X+1 LIN_Z-6",
    "GRV RADIAL CENTER-20 DEPTH3 BREADTH4 FAR_CHF1",
    "CP IPA-1800 IZ+5 DR- RL F50",
    'SEL CONTOUR "a.h"',
    "STOP M6",
    "TRANS DATUM TABLE TABLINE5",
    "TRANS MIRROR AXIS X Y",
    "TRANS MIRROR RESET",
    "TRANS ROTATION ROT+12.5",
    "TRANS ROTATION IROT-Q5",
    "TRANS SCALE SCL0.995",
    "PLANE RESET STAY",
    "PLANE SPATIAL SPA+0 SPB+20 SPC+0 MOVE DIST50 F1000",
    "FUNCTION RESET TCPM",
    "FN14: ERROR = +Q5",
    'DECLARE CONTOUR QC1 = "TNC:\\A.H" DEPTH5',
    "declare contour QC2 = LBL QS3",
    "DECLARE CONTOUR QC3 = QS7",
    "QC10 = QC1",
    "QC10 = ( QC1|QC2 ) \\ ( QC3 & ( QC4 ^ QC5 ) )",
    'CONTOUR DEF P1 = LBL 1 ~\n    I2 = "B.H" DEPTH+Q5 ~\n    V3 = LBL "C" ;the rest',
  ])("%s is understood", (text) => expect(parse(text).blocks.map(({ issues = [] }) => issues)).toEqual([[]]));
});

test.each([
  "QC1 = QC2 QC3",
  "QC1 = | QC2",
  "QC1 = ( QC2",
  "QC1 = QC2 )",
  "QC1 = QC2 + QC3",
  "QC1 =",
  "DECLARE CONTOUR QC1 = 7",
  "CONTOUR DEF P1 = LBL 1 ~\n    FOO 7",
  "FN 14: ERROR",
])("%s is kept as text", (text) => {
  const block = one(text);
  expect(block?.statement.kind).toBe("unknown");
  expect(print(parse(text))).toBe(text);
});

test("an area of several lines is read with correct positions", () => {
  const block = one("7 CONTOUR DEF ~\n  P1 = LBL 1 ~ \n  I12 = QS4 DEPTH0.5");
  expect(block?.statement).toEqual({
    kind: "contourDefinition",
    areas: [
      { role: "P", number: 1, from: { label: 1 }, depth: null },
      {
        role: "I",
        number: 12,
        from: { file: { parameter: "QS4", negative: false } },
        depth: 0.5,
      },
    ],
  });
  expect(block?.lines).toBe(3);
});

test("10,000 blocks are read, each as if alone", () => {
  const text = Array.from({ length: 10_000 }, (_, i) => `${i} L  X+${i % 90}.5 Z-${i % 70} R0 FMAX  M3\n`).join("");
  const { blocks } = parse(text);
  expect(blocks).toHaveLength(10_000);
  for (const i of [0, 4999, 9999])
    expect(blocks[i]?.statement).toEqual(one(`${i} L  X+${i % 90}.5 Z-${i % 70} R0 FMAX  M3`)?.statement);
});

test("numbering in tens is reported once, a jump in it again", () => {
  const counted = (...numbers: number[]) =>
    issuesOf(parse(numbers.map((n) => `${n} M8\n`).join("")))
      .filter((i) => i.code === "blockNumber")
      .map((i) => i.data);
  expect(counted(10, 20, 30, 40)).toEqual([{ found: 20, expected: 11 }]);
  expect(counted(10, 20, 30, 35, 45)).toEqual([
    { found: 20, expected: 11 },
    { found: 35, expected: 31 },
    { found: 45, expected: 36 },
  ]);
  expect(counted(1, 2, 2, 2, 3)).toEqual([
    { found: 2, expected: 3 },
    { found: 2, expected: 3 },
  ]);
});

/** Most characters of a line, as decided in docs/decisions/0060: the code must not read more. */
const LONGEST_LINE = 2000;

test.each([
  ["a straight line", `1 L X+1${" ".repeat(LONGEST_LINE)}\n`, 0],
  ["words", `1 L ${"X+1 ".repeat(LONGEST_LINE)}\n`, 0],
  ["a comment", `1 M3 ;${"x".repeat(LONGEST_LINE)}\n`, 0],
  ["the second line of a cycle", `1 CYCL DEF 7.0 A ~\nQ200=+1 ;${"x".repeat(LONGEST_LINE)}\n`, 19],
])("a line longer than a block can be is kept, reported and not read: %s", (_, long, offset) => {
  const program = parse(`0 M3\n${long}2 M5\n`);
  expect(print(program)).toBe(`0 M3\n${long}2 M5\n`);
  expect(program.blocks.map(({ statement }) => statement.kind)).toEqual(["functions", "unknown", "functions"]);
  expect(program.blocks[1]?.issues).toMatchObject([{ code: "lineTooLong", offset, data: { most: LONGEST_LINE } }]);
});

test("a line of the longest length is read", () => {
  const { blocks } = parse(`1 L X+1 ;${"x".repeat(LONGEST_LINE - 9)}\n`);
  expect(blocks.map(({ statement, issues = [] }) => [statement.kind, issues])).toEqual([["path", []]]);
});

test("consecutive words that are not understood are one finding over their full length", () => {
  const issues = one("5 L FOO  BAR X+5 BAZ Z-1")?.issues ?? [];
  const [first, second] = issues;
  expect(first).toMatchObject({ code: "wordNotUnderstood", offset: 4, length: 8, data: { text: "FOO  BAR" } });
  expect(second).toMatchObject({ code: "wordNotUnderstood", offset: 17, length: 3 });
  expect(issues).toHaveLength(2);
});

test("coordinates that are nearly equal, or of another axis, are read as they are", () => {
  const lines = ["X+1.00001", "X+1.00002", "IX+1.00001", "Z+1.00001", "X-1.00001", "X+1.00001"];
  const { blocks } = parse(lines.map((word) => `L ${word}\n`).join(""));
  expect(blocks.map(({ statement: s }) => (s.kind === "path" ? s.words.axes : []))).toEqual(
    [
      ["X", 1.00001, false],
      ["X", 1.00002, false],
      ["X", 1.00001, true],
      ["Z", 1.00001, false],
      ["X", -1.00001, false],
      ["X", 1.00001, false],
    ].map(([axis, value, incremental]) => [{ axis, value, incremental }]),
  );
});

test("a plain line of a long program keeps no more than it says, and equal coordinates once", () => {
  const [first, second] = parse("1 L X+20 Z-5\n2 L X+20 Z-6\n").blocks;
  expect(Object.keys(first ?? {}).toSorted()).toEqual(["lines", "number", "raw", "statement"]);
  const words = [first, second].map((b) => (b?.statement.kind === "path" ? b.statement.words : null));
  expect(Object.keys(words[0] ?? {}).toSorted()).toEqual(["axes", "functions"]);
  expect(words[1]?.axes[0]).toBe(words[0]?.axes[0]);
});
