import { describe, expect, test } from "vitest";
import { refusals } from "./refusals.ts";

const file = (...lines: readonly string[]) => ["%A G71 *", ...lines, "N99999999 %A G71 *"].join("\r\n");
const found = (text: string) => refusals(text, "iso").map((r) => `${r.code} ${r.block}:${r.line}:${r.column}`);

describe("one DIN/ISO line that a control refuses, and a similar one that it accepts", () => {
  test.each([
    ["N10 G01 X+5", "starMissing 10:2:12", "N10 G01 X+5*"],
    ["N10 G820 Q215=+0", "starMissing 10:2:17", "N10 G820 Q215=+0 Q460=+2 *"],
    ["N10 L X+5 *", "unknownWord 10:2:5", "N10 L2,0 *"],
    ["N10 LBL 2 *", "unknownWord 10:2:5", "N10 G98 L2 *"],
    ["N10 STOP CALL 5 *", "unknownWord 10:2:5", "N10 T5.1 G17 S3000 DL+0.1 DR-0.1 *"],
    ["N10 CYCL CALL *", "unknownWord 10:2:5", "N10 G79 M3 *"],
    ["N10 CYCL CALL M3 *", "unknownWord 10:2:5", "N10 CYCL CALL POS X+5 *"],
    ["N10 G24 X *", "valueMissing 10:2:10", "N10 G28 X Y *"],
    ["N10 T0.02 *", "tooManyDigits 10:2:6", "N10 G62 T0.02 *"],
    ["N10 CALL LBL 2 *", "unknownWord 10:2:5", "N10 CALL PGM TNC:\\A.I *"],
    ["N10 CR X+5 R+3 DR+ *", "unknownWord 10:2:5", "N10 G02 X+5 Z-3 R+3 *"],
    ["N10 G1000000 *", "outOfRange 10:2:6", "N10 G01 *"],
    ["N10 G01 X *", "valueMissing 10:2:10", "N10 G01 X+.5 I+3 J,5 H-30 *"],
    ["N10 G01 X--3 *", "badNumber 10:2:10", "N10 G01 X-3 F MAX *"],
    ["N10 G01 X+100000 *", "outOfRange 10:2:10", "N10 G00 G40 G90 X+99999.9999 *"],
    ["N10 G01 Z0.1234567 *", "tooManyDigits 10:2:10", "N10 G01 Z0.123456 FQ3 *"],
    ["N10 G98 L70000 *", "outOfRange 10:2:10", 'N10 G98 L"ENDE" *'],
    ["N10 G98 L2.5 *", "tooManyDigits 10:2:10", "N10 L2,5 *"],
    ["N10 T40000 *", "outOfRange 10:2:6", 'N10 T"DRILL" G17 *'],
    ["N10 G00 M1 M2 M3 M4 M5 *", "tooManyFunctions 10:2:21", "N10 M1 M2 M3 M4 *"],
    ["10 G01 X+5 *", "blockNumber 1:2:1", "G01 X+5 *"],
    ["N1.5 G01 X+5 *", "blockNumber 1:2:1", "/N15 G01 X+5 *"],
    ["N10 D01 Q2000 P01 +1 P02 +2 *", "outOfRange 10:2:9", 'N10 D09 P01 +Q1 P02 +2 P03 "X" *'],
    ["N10 Q5 = 2 3 *", "formulaBroken 10:2:12", "N10 Q5 = ( 2 * 3 ) *"],
    ["N10 FUNCTION MODE SAW *", "unknownWord 10:2:19", "N10 FUNCTION MODE TURN *"],
    ["N10 G37 P01 X *", "unknownWord 10:2:13", "N10 G37 P01 2 *"],
  ])("%s", (refused, where, taken) => {
    expect(found(file(refused))).toEqual([where]);
    expect(found(file(taken))).toEqual([]);
  });
});

describe("lists, remarks, frame", () => {
  test.each([
    ["a list over several lines", ["N10 G820 TURN CONTOUR ~", "  Q215=+0 ;A ~", "Q460=+2 ;B *", "N20 G79 *"], []],
    ["without ~", ["N10 G820", "Q215=+0 ;A", "Q460=+2 ;B *"], ["listWithoutTilde 10:3:1"]],
    ["~ behind its last line", ["N10 G820 ~", "Q215=+0 ~", "N20 G79 *"], ["tildeAtEnd 10:3:9"]],
    ["without * behind its last line", ["N10 G820 ~", "Q215=+0 ;A", "N20 G79 *"], ["starMissing 10:3:8"]],
    ["remarks with and without *", ["N10 ;turn *", "; off", "N20 * - PART *", "* - PART", "N30 G01 X+5 ;half *"], []],
    [
      "Klartext functions",
      [
        "N1 BLK FORM CYLINDER Z D50 L20 *",
        "N2 UDC TYPE_E R1 *",
        "N3 APPR CT X+1 CCA90 R+3 RR *",
        "N4 CYCL DEF 7.1 X+3 *",
      ],
      [],
    ],
    ["a program that is called", ["N10 %B.I *"], []],
    ["a label twice", ["G98 L2 *", "G98 L0 *", "G98 L0 *", "N7 G98 L2 *"], ["labelTwice 7:5:9"]],
  ])("%s", (_, lines, where) => expect(found(file(...lines))).toEqual(where));
  test.each([
    ["", ["beginMissing null:1:1", "endMissing null:1:1"]],
    ["N10 G01 *\nN99 %A G71 *", ["beginMissing 10:1:5"]],
    ["%A *\nN9 %A G71 *", ["unitMissing 0:1:3"]],
    ["%A G71 *\nN9 %B G71 *", ["nameDiffers 9:2:5"]],
    ["%A G70 *\nN10 G01 *", ["endMissing 10:2:1"]],
    ["%A G71\nN9 %A G71 *", ["starMissing 0:1:7"]],
    ["%A G71 *\nN9 %A G71 *\nN10 M3 *", ["outsideProgram 10:3:5"]],
  ])("%j", (text, where) => expect(found(text)).toEqual(where));
});

describe("any text", () => {
  const hostile = [
    " ".repeat(20_000),
    '"'.repeat(20_001),
    "(".repeat(20_000),
    "Q1 ".repeat(20_000),
    " Q1=".repeat(20_000),
    "~\n".repeat(20_000),
  ];
  const more = [
    "9".repeat(20_000),
    "+".repeat(20_000),
    "L X+",
    "\u0000\ud800",
    "Q".repeat(20_000),
    "LBL 1\n".repeat(5_000),
    "CYCL DEF 200\nQ200=1\n".repeat(5_000),
  ];
  const openers = [
    "",
    "1 ",
    "L X",
    "Q1 = ",
    "CYCL DEF 200 ",
    "N1 G200 ",
    "IF ",
    "UDC TYPE_E ",
    "TOOL CALL ",
    "BEGIN PGM ",
    "%",
  ];
  test.each(openers)("after %j is read", (opener) => {
    for (const text of [...hostile, ...more]) {
      for (const control of ["tnc640", "tnc7", "iso"] as const) {
        const found = refusals(opener + text, control);
        expect(found.length).toBeGreaterThan(0);
        expect(found.filter(({ line, column }) => line < 1 || column < 1)).toEqual([]);
      }
    }
  });
});
