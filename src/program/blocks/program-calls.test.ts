import { describe, expect, test } from "vitest";
import { toDiameter } from "../../kernel/units.ts";
import { parse } from "../../nc/parse.ts";
import { fileKey, filesByName } from "../state/program-files.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";

const head =
  "0 BEGIN PGM T MM\n1 BLK FORM CYLINDER Z D80 L100 DIST+1 DI20\n2 FUNCTION MODE TURN\n3 TOOL CALL 1\n4 FUNCTION TURNDATA " +
  "SPIN VCONST:OFF S500\n5 M136\n6 L X+100 Z+50 R0 FMAX M303\n";
const made = (lines: string, files: Readonly<Record<string, string>> = {}, skipMarked = false) =>
  run(parse(`${head}${lines}\nM30\nEND PGM T MM\n`), {
    tools: shippedTools,
    rapid: 10_000,
    files: filesByName(
      Object.entries(files).map(([name, text]) => ({ name, text })),
      parse,
    ),
    skipMarked,
  });
type Made = ReturnType<typeof made>;
const path = (r: Made) =>
  r.steps.map((s) => `${s.block} ${+toDiameter(s.move.to.r).toFixed(3)} ${+s.move.to.z.toFixed(3)}`);
const told = (r: Made) => r.issues.filter((f) => f.issue.severity !== "info").map((f) => `${f.issue.code}@${f.block}`);
const unproved = (r: Made) => r.unproved.map((u) => `${u.what}@${u.block}`);

/** A complete program text with BEGIN and END. */
const pgm = (lines: string, unit = "MM") => `BEGIN PGM S ${unit}\n${lines}\nEND PGM S ${unit}\n`;

describe("names of files", () => {
  test.each([
    ["CUT", "CUT.H"],
    ["cut.h", "CUT.H"],
    ["TNC:\\work\\Cut.h", "CUT.H"],
    ["../sub/cut", "CUT.H"],
    ["a.i", "A.I"],
    ["", ""],
  ])("%s is compared as %s", (name, key) => expect(fileKey(name)).toBe(key));
});

describe("a program calls another", () => {
  test("its moves carry the number of the call and the name of the file", () => {
    const r = made("CALL PGM TNC:\\work\\cut\nL Z+7.3 FMAX", { "CUT.H": pgm("L X+91.7 FMAX\nL Z+3.1 FMAX") });
    expect(path(r)).toEqual(["7 91.7 50", "7 91.7 3.1", "8 91.7 7.3"]);
    expect(r.steps.map((s) => s.file)).toEqual(["CUT.H", "CUT.H", undefined]);
    expect(r.stepBlocks).toEqual([7, 7, 8]);
    expect(told(r)).toEqual([]);
  });
  test("by SEL PGM, by a text, and by cycle 12 with CYCL CALL and M99", () => {
    const files = { "a.h": pgm("L IX-1.5 FMAX") };
    expect(path(made('SEL PGM "A.H"\nCALL SELECTED PGM\nCALL SELECTED PGM', files))).toEqual(["8 98.5 50", "9 97 50"]);
    expect(path(made('QS3 = "TNC:\\" || "A"\nSEL PGM QS3\nCALL SELECTED PGM', files))).toEqual(["9 98.5 50"]);
    expect(
      path(made("CYCL DEF 12.0 PGM CALL\nCYCL DEF 12.1 PGM TNC:\\A.H\nL Z+40 FMAX M99\nCYCL CALL", files)),
    ).toEqual(["9 100 40", "9 98.5 40", "10 97 40"]);
  });
  test("it has labels, local parameters and a unit of its own; Q parameters are shared", () => {
    const files = { "S.H": pgm("Q1 = Q1 / 25.4\nQL1 = 3\nCALL LBL 1\nLBL 1\nL IZ+0.1 FMAX\nLBL 0", "INCH") };
    const r = made(
      "Q1 = 50.8\nQL1 = 71\nCALL PGM S\nL X+QL1 Z+Q1 FMAX\nCALL LBL 1\nM30\nLBL 1\nL IZ+0.1 FMAX\nLBL 0",
      files,
    );
    expect(path(r)).toEqual(["9 100 52.54", "9 100 55.08", "10 71 2", "14 71 2.1"]);
    expect(told(r)).toEqual([]);
  });
  test("findings stand at the call, with their place in the file", () => {
    const r = made("CALL PGM S", { "S.H": pgm("; a note\n3 L X+Q77 FMAX\n4 CALL LBL 9\n5 M2") });
    expect(told(r)).toEqual(["parameterUnset@7", "labelMissing@7", "endInCalled@7"]);
    expect(r.issues.find((f) => f.issue.code === "labelMissing")).toMatchObject({
      line: 8,
      inFile: { file: "S.H", block: 4, line: 4 },
    });
    expect(made("CALL PGM S", { "S.H": pgm("L X+90 FMAX") }).issues.filter((f) => f.inFile)).toEqual([]);
  });
  test("a missing one is named, and the rest is unverified", () => {
    const r = made("CALL PGM NOWHERE.H\nL X+90 FMAX");
    expect(unproved(r)).toEqual(["CALL PGM@7"]);
    expect(r.issues.map((f) => f.issue)).toContainEqual(
      expect.objectContaining({ code: "programNotOpened", data: { file: "NOWHERE.H" } }),
    );
    expect(told(made("CALL SELECTED PGM"))).toEqual(["programNotSelected@7"]);
    expect(
      unproved(made("SEL PGM QS1\nFN 18: SYSREAD Q1 = ID1\nQS1 = TOCHAR ( DAT+Q1 )\nSEL PGM QS1\nCALL SELECTED PGM")),
    ).toContain("CALL SELECTED PGM@11");
  });
  test("endless recursion stops with its cause", () => {
    expect(told(made("CALL PGM S", { "S.H": pgm("L IX+1 FMAX\nCALL PGM S") }))).toEqual(["programsTooDeep@7"]);
    expect(told(made("CALL PGM A", { "A.H": pgm("CALL PGM B"), "B.H": pgm("CALL PGM A") }))).toEqual([
      "programsTooDeep@7",
    ]);
    expect(told(made("CALL PGM S\nCALL PGM S", { "S.H": pgm("L IX+1 FMAX") }))).toEqual([]);
  });
  test("a program that comes back out of a repetition goes on with it", () =>
    expect(
      path(made("LBL 4\nCALL PGM S\nCALL LBL 4 REP 2", { "S.H": pgm("LBL 4\nL IX+1 FMAX\nCALL LBL 4 REP 1") })),
    ).toHaveLength(6));
});

const SHOULDER =
  "TOOL CALL 15\nL Z+50 FMAX\nCYCL DEF 820 TURN CONTOUR TRANSV. ~\nQ215=+0 ~\nQ460=+2 ~\nQ499=+0 ~\nQ463=+2 ~\nQ478=+0.3 ~\n" +
  "Q483=+0 ~\nQ484=+0 ~\n" +
  "Q505=+0.2 ~\nQ487=+1 ~\nQ488=+0 ~\nQ479=+0 ~\nQ480=+0 ~\nQ482=+0 ~\nQ506=+0\nL X+82 Z+3 FMAX\nCYCL CALL";
const OUTLINE = "L X+80 Z-20.5\nL X+50\nL Z+0";
const contourOf = (r: Made) =>
  r.operations[0]?.call?.given.contour?.map((s) => `${+toDiameter(s.to.r).toFixed(3)} ${+s.to.z.toFixed(3)}`);

describe("contours from files", () => {
  const inside = made(`CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 LABEL1\n${SHOULDER}\nM30\nLBL 1\n${OUTLINE}\nLBL 0`);
  test.each([
    ["SEL CONTOUR", 'SEL CONTOUR "TNC:\\c\\outline.h"', { "OUTLINE.H": pgm(OUTLINE) }],
    ["a name in a parameter", 'QS1 = "OUTLINE"\nSEL CONTOUR QS1', { "OUTLINE.H": pgm(OUTLINE) }],
    [
      "a file that declares a contour",
      'SEL CONTOUR "ALL"',
      {
        "ALL.H": pgm('DECLARE CONTOUR QC1 = "OUTLINE.H"\nQC2 = QC1'),
        "OUTLINE.H": pgm(OUTLINE),
      },
    ],
    ["CONTOUR DEF with a file", 'CONTOUR DEF P1 = "OUTLINE.H"', { "OUTLINE.H": pgm(OUTLINE) }],
    [
      "an inch file",
      'SEL CONTOUR "O.H"',
      { "O.H": pgm(`L X+${80 / 25.4} Z-${20.5 / 25.4}\nL X+${50 / 25.4}\nL Z+0`, "INCH") },
    ],
  ])("%s", (_, lines, files) => {
    const r = made(`${lines}\n${SHOULDER}`, files);
    expect(told(r)).toEqual([]);
    expect(contourOf(r)).toEqual(["50 -20.5", "50 0"]);
    expect(r.steps.length).toBe(inside.steps.length);
    expect(r.operations[0]?.plan.passes).toBeGreaterThan(2);
  });
  test("CONTOUR DEF with a label", () =>
    expect(contourOf(made(`CONTOUR DEF P1 = LBL "A"\n${SHOULDER}\nM30\nLBL "A"\n${OUTLINE}\nLBL 0`))).toEqual([
      "50 -20.5",
      "50 0",
    ]));
  test("several areas are not joined: the cycle is unproved", () =>
    expect(unproved(made(`CONTOUR DEF P1 = "A.H" I2 = "B.H" DEPTH5\n${SHOULDER}`))).toEqual(["CYCL CALL@12"]));
  test("a missing file is an error of the cycle", () =>
    expect(told(made(`SEL CONTOUR "A.H"\n${SHOULDER}`))).toContain("contourInFile@12"));
});

describe("blocks that are marked with /", () => {
  const lines = "/L X+90 FMAX\n8 / L X+80 FMAX\nL Z+7 FMAX\n/ CALL LBL 9";
  test("run, unless the switch is on", () => {
    expect(path(made(lines))).toEqual(["7 90 50", "8 80 50", "9 80 7"]);
    expect(told(made(lines))).toEqual(["labelMissing@10"]);
    expect(path(made(lines, {}, true))).toEqual(["9 100 7"]);
    expect(told(made(lines, {}, true))).toEqual([]);
  });
  test("a label that is left out is none, and so is an element of a contour", () => {
    expect(told(made("CALL LBL 1\nM30\n/LBL 1\nLBL 1\nL X+90 FMAX\nLBL 0"))).toEqual(["labelTwice@10"]);
    expect(told(made("CALL LBL 1\nM30\n/LBL 1\nLBL 1\nL X+90 FMAX\nLBL 0", {}, true))).toEqual([]);
    const outlined = made(
      `CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 LABEL1\n${SHOULDER}\nM30\nLBL 1\n${OUTLINE}\n/L X+88\nLBL 0`,
      {},
      true,
    );
    expect(contourOf(outlined)).toEqual(["50 -20.5", "50 0"]);
  });
});

describe("values", () => {
  const at = (lines: string) =>
    path(made(`${lines}\nL X+Q9 FMAX`))
      .at(-1)
      ?.split(" ")[1];
  test.each([
    ["FN 6: Q9 = SIN-Q1", "Q1 = -30", "0.5"],
    ["FN6:Q9=SIN +90", "", "1"],
    ["FN 7: Q9 = COS+60", "", "0.5"],
    ["FN 8: Q9 = +6 LEN -8", "", "10"],
    ["FN 13: Q9 = +5 ANG-5", "", "135"],
    ["FN 13: Q9 = -5 ANG+5", "", "315"],
    ["Q9 = ASIN 0.5 + ACOS 0.5 + ATAN 1", "", "135"],
    ["Q9 = SQ ( 1 + 2 ) ^ 2 % 50", "", "31"],
    ["Q9 = NEG ( LOG 0.01 ) + LN EXP 3 + SGN -7 + INT 2.9 + FRAC 2.25 + ABS -1", "", "7.25"],
    ["Q9 = TAN 45 * PI", "", "3.142"],
    ["Q9 = 2 ^ 3 ^ 2 / 64", "", "8"],
    ["Q9 = ( 2 ^ 3 ) ^ 2", "", "64"],
    ["Q9 = - 3 ^ 2 + SIN 30 ^ 2", "", "9.25"],
    ["Q9 = 2 - 3 - 4 + 60 / 4 / 5", "", "-2"],
    ["Q9 = Q113 + 5", "", "5"],
    ["Q9 = Q463 + 1", "CYCL DEF 200 DRILLING ~\nQ201=-20 ~\nQ463=+2.25", "3.25"],
    ["Q9 = STRLEN ( SRC_QS1 )", 'QS1 = "CUT12.H"', "7"],
    ["Q9 = INSTR ( SRC_QS1 SEA_QS2 BEG1 )", 'QS1 = "ABCAB"\nQS2 = "AB"', "3"],
    ["Q9 = TONUMB ( SRC_QS1 )", 'QS2 = "X12,5"\nQS1 = SUBSTR ( SRC_QS2 BEG1 LEN4 )', "12.5"],
    ["Q9 = 4 + STRCOMP ( SRC_QS1 SEA_QS2 )", 'QS1 = "A"\nDECLARE STRING QS2 = "B"', "3"],
    ["Q9 = TONUMB ( SRC_QS1 )", 'QS1 = "1" || TOCHAR ( DAT+2.346 DECIMALS2 )', "12.35"],
  ])("%s with %s is %s", (formula, before, result) => expect(at(`${before}\n${formula}`)).toBe(result));
  test("parameters of the control: the tool radius in program units; all others are unknown and no fault", () => {
    const mills = [{ T: 31, NAME: "D8", R: 4, DR: -0.25 }];
    const radius = (unit: string, lines: string) => {
      const text = `BEGIN PGM R ${unit}\nTOOL DEF 7 L+0 R+0.75\n${lines}\nL X+0 Y+0 Z+5 R0 FMAX\nL X+Q108 FMAX\nM30\nEND PGM R ${unit}\n`;
      const r = run(parse(text), { tools: shippedTools, rapid: 10_000, mills });
      return [
        r.plane.at(-1)?.to.x ?? null,
        ...unproved(r).filter((u) => u.startsWith("Q")),
        ...told(r).filter((c) => !c.startsWith("not")),
      ];
    };
    expect(radius("MM", "TOOL CALL 31 Z S100 DR+0.5")).toEqual([4.25]);
    expect(radius("INCH", "TOOL CALL 7 Z S100")).toEqual([0.75 * 25.4]);
    expect(radius("MM", "TOOL CALL 77 Z S100")).toEqual([0, "Q108@4"]);
    expect(unproved(made("L X+Q110 FMAX"))).toEqual(["Q110@7"]);
    expect(told(made("L X+Q99 FMAX"))).toEqual(["parameterUnset@7"]);
    expect(
      unproved(made("FN 18: SYSREAD Q1 = ID1\nQ200 = 3\nCYCL DEF 200 DRILLING ~\nQ200=+Q1\nL X+Q200 FMAX")),
    ).toEqual(["Q1@9", "Q200@10"]);
  });
  test("a tool by its name in a parameter", () => {
    const name = shippedTools[1]?.NAME ?? "";
    const r = made(`QS1 = "${name}"\nTOOL CALL QS1\nL X+90 Z+5 FMAX\nL X+80 FMAX`);
    expect(r.steps.at(-1)?.tool.NAME).toBe(name);
    expect(told(made("TOOL CALL QS8"))).toEqual(["parameterUnset@7"]);
  });
  test("an unknown tool is unverified, and no fault", () => {
    const r = made("FN 18: SYSREAD Q1 = ID20 NR1\nTOOL CALL Q1\nL X+90 Z+5 FMAX");
    expect(unproved(r)).toEqual(["Q1@8"]);
    expect(r.issues.filter((f) => f.issue.severity === "error")).toEqual([]);
  });
  test("labels and jumps by parameters, comparisons of texts", () => {
    const lines = 'QS1 = "E" || "ND"\nQS2 = "END"\nIF QS1 EQU QS2 GOTO LBL QS1\nL X+90 FMAX\nLBL "END"\nL Z+3 FMAX';
    expect(path(made(lines))).toEqual(["12 100 3"]);
    expect(path(made("Q5 = 7\nFN 9: IF+1 EQU+1 GOTO LBL Q5\nL X+90 FMAX\nLBL 7\nL Z+3 FMAX"))).toEqual(["11 100 3"]);
    expect(path(made("Q5 = 2\nLBL 7\nL IZ-1 FMAX\nCALL LBL 7 REP Q5"))).toHaveLength(3);
  });
  test("values of a table, a probe or the machine are unknown, and so is what depends on them", () => {
    expect(unproved(made('SQL SELECT Q5 "SELECT R FROM T"\nL X+Q5 FMAX'))).toEqual(["Q5@8"]);
    expect(unproved(made('SQL BIND Q5 "T.R"\nQ5 = 4\nSQL FETCH Q1 HANDLE Q2\nL X+Q5 FMAX'))).toEqual(["Q5@10"]);
    expect(unproved(made("QS1 = SYSSTR ( ID10950 NR1 )\nQ2 = STRLEN ( SRC_QS1 )\nL X+Q2 FMAX"))).toEqual(["Q2@9"]);
    expect(unproved(made("Q2 = CFGREAD ( KEY_QS1 TAG_QS2 )\nL X+Q2 FMAX"))).toEqual(["Q2@8"]);
    expect(unproved(made("Q150 = 3\nTCH PROBE 427 MEASURE ~\nQ263=+1\nL Z+Q150 FMAX"))).toEqual([
      "TCH PROBE 427@8",
      "Q150@9",
    ]);
    expect(unproved(made("Q2 = 90\nL X+Q2 FMAX"))).toEqual([]);
  });
  test("SET UNDEFINED removes a value", () =>
    expect(
      path(made("Q5 = 4\nQ5 = SET UNDEFINED\nIF Q5 IS UNDEFINED GOTO LBL 1\nL X+90 FMAX\nLBL 1\nL Z+1 FMAX")),
    ).toEqual(["12 100 1"]));
  test("FUNCTION TURNDATA SPIN keeps the gear", () => {
    const [block] = parse("4 FUNCTION TURNDATA SPIN VCONST:ON VC:180 SMAX2000 GEARRANGE:2\n").blocks;
    expect(block).toBeDefined();
    expect(block?.issues).toBeUndefined();
    expect(block?.statement).toMatchObject({ kind: "spin", limit: 2000, gear: 2 });
  });
});
