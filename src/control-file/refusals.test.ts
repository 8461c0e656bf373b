import { describe, expect, test } from "vitest";
import { refusals } from "./refusals.ts";

const file = (...lines: readonly string[]) => ["0 BEGIN PGM A MM", ...lines, "99 END PGM A MM"].join("\n");
/** Each refusal as `code block:line:column`. */
const found = (text: string) => refusals(text, "tnc640").map((r) => `${r.code} ${r.block}:${r.line}:${r.column}`);

describe("one line that a control refuses, and a similar one that it accepts", () => {
  test.each([
    // Words.
    ["1 LX+5 GRID", "unknownWord 1:2:8", "1 LX+5 R0"],
    ["1 FRAES X+5", "unknownWord 1:2:3", "1 FC X+5 DR+ R4"],
    ["1 G01 X+5", "unknownWord 1:2:3", "1 X+5 R+ F100"],
    ["1 CYCLE DEF 9.0", "unknownWord 1:2:3", "1 CYCL DEF 9.0"],
    ["1 L X+5 S1000", "unknownWord 1:2:9", "1 L X+5 M140 MB MAX F1000"],
    ["1 APPR LR X+5", "unknownWord 1:2:8", "1 APPR PLCT PR+5 PA+3 R2 RR"],
    ["1 BLK FORM KEGEL Z", "unknownWord 1:2:12", "1 BLK FORM ROTATION Z DIM_D LBL 7"],
    ["1 BLK FORM CYLINDER Z D50 H20", "unknownWord 1:2:27", "1 BLK FORM CYLINDER Z D50 L20 DIST+0,5 DI12.3"],
    ["1 FUNCTION MODE DREHEN", "unknownWord 1:2:17", '1 FUNCTION MODE TURN "AC"'],
    ["1 FUNCTION TURNDATA SPIN VCONST:AN", "unknownWord 1:2:33", "1 FUNCTION TURNDATA SPIN VCONST:ON VC:Q5 SMAX3000"],
    ["1 UDC TYPE_G R1", "unknownWord 1:2:7", "1 UDC TYPE_K R1 DEPTH2 ROT+45"],
    ["1 LBL 3 REP 2", "unknownWord 1:2:9", "1 LBL 3"],
    ["1 CALL LBL 3 5", "unknownWord 1:2:14", "1 CALL LBL 3 REP 2/2"],
    ["1 TOOL CALL 5 Z S200 K3", "unknownWord 1:2:22", "1 TOOL CALL 5.2 Z S200 FU0.2 DL+0,1 DR-.5"],
    ["1 FN 9: FALLS +Q1 EQU +2", "unknownWord 1:2:9", '1 FN 9: IF +Q1 EQU +2 GOTO LBL "A"'],
    ["1 Q5 = SET +3", "unknownWord 1:2:12", "1 Q5 = SET UNDEFINED"],
    // Values.
    ["1 L X", "valueMissing 1:2:6", "1 L X+.5 R F M"],
    ["1 L Z ;X+5", "valueMissing 1:2:6", "1 L Z3. ;X"],
    ["1 LBL", "valueMissing 1:2:6", "1 LBL QS5"],
    ['1 LBL ""', "valueMissing 1:2:7", '1 LBL " "'],
    ["1 FN 12: IF +Q1 LT +2", "valueMissing 1:2:12", "1 IF Q1 IS DEFINED GOTO LBL QS7"],
    ["1 L X--5", "badNumber 1:2:6", "1 L X - 5"],
    ["1 L X1.2.3", "badNumber 1:2:6", "1 L X1,2Y3"],
    ["1 L Y+1e5", "badNumber 1:2:6", "1 L Y+1 A+5"],
    ["1 L X+ Z+1", "badNumber 1:2:6", "1 L X+Q1 Z+1"],
    ["1 L X+123456.7", "outOfRange 1:2:6", "1 L X-99999.9999"],
    ["1 L X+1 M1000", "outOfRange 1:2:10", "1 L X+1 M999"],
    ["1 L X+1 F-3", "outOfRange 1:2:10", "1 L X+1 F99999.999"],
    ["1 L X+Q2000", "outOfRange 1:2:7", "1 L X+Q1999 YQL499"],
    ["1 QR500 = 3", "outOfRange 1:2:3", "1 QR499 = 3"],
    ["1 LBL 65536", "outOfRange 1:2:7", "1 LBL 65535"],
    ["1 CALL LBL 1 REP 65535", "outOfRange 1:2:18", "1 CALL LBL 1 REP65534"],
    ["1 TOOL CALL 32768", "outOfRange 1:2:13", "1 TOOL CALL 32767.9"],
    ["1 TOOL CALL S-1", "outOfRange 1:2:14", "1 TOOL CALL S+Q4"],
    ["1 TOOL CALL DR+100", "outOfRange 1:2:15", "1 TOOL CALL DR+99.9999"],
    ["1 FN 14: ERROR=1200", "outOfRange 1:2:16", "1 FN 14: ERROR = 1199"],
    ["1 L X+0.1234567", "tooManyDigits 1:2:6", "1 LN X+0.123456 NX-0.1234567 TZ0.1"],
    ["1 L X+1234567890", "tooManyDigits 1:2:6", "1 L X+00000000001"],
    ["1 LBL 2.5", "tooManyDigits 1:2:7", "1 LBL 25"],
    ["1 L M1 M2 M3 M4 M5", "tooManyFunctions 1:2:17", "1 M1 M2 M3 M4"],
    // Texts, brackets, formulas.
    ['1 SEL PGM "A.H', "stringOpen 1:2:11", '1 SEL PGM "A;B.H" ;C "'],
    ["1 Q1 = ( Q2 + 3", "bracketOpen 1:2:8", "1 Q1 = ( Q2 + 3 ) * SIN ( - Q4 )"],
    ["1 QS1 = SUBSTR ( SRC_QS2 BEG1", "bracketOpen 1:2:16", '1 QS1 = "A;" || SUBSTR ( SRC_QS2 BEG1 LEN2 )'],
    ["1 L X+{LEN", "bracketOpen 1:2:7", "1 L X+{LEN}"],
    ["1 Q1 = Q2 3", "formulaBroken 1:2:11", "1 Q1 = Q2 ^ 3"],
    ["1 Q1 = Q2 *", "formulaBroken 1:2:11", "1 Q1 = Q2 * - 1,5"],
    ["1 Q1 = 2 )", "formulaBroken 1:2:10", "1 QC1 = ( QC2 | QC3 ) \\ QC4"],
    ["1 Q5 25", "equalsMissing 1:2:6", "1 Q5=25"],
    ["1 Q5 =", "valueMissing 1:2:7", "1 FN 4: Q5 = +Q1 DIV +2"],
    // Block numbers.
    ["1.5 L X+1", "blockNumber 1:2:1", "/ 15 L X+1"],
    ["N1 L X+1", "blockNumber 1:2:1", "1 /L X+1"],
    ["-3 L X+1", "blockNumber 1:2:1", "L X+1"],
  ])("%s", (refused, where, taken) => {
    expect(found(file(refused))).toEqual([where]);
    expect(found(file(taken))).toEqual([]);
  });
});

describe("lists", () => {
  const list = ["7 CYCL DEF 200 BOHREN ~", "    Q200=+2 ;A ~", "Q201=-1,5 ~ ", "Q206= FMAX ~", "Q9=AUTO"];
  test("with ~ on each line but the last", () => expect(found(file(...list))).toEqual([]));
  test("in one line, and without parameters", () =>
    expect(found(file("7 CYCL DEF 200 B Q200=+2 Q201=-3", "8 CYCL DEF 801 RESET"))).toEqual([]));
  test("over blank lines and long comments", () =>
    expect(
      found(
        file(
          "7 CYCL DEF 200 B ~",
          "",
          "Q200=+2 ;VERY LONG~",
          " COMMENT ~",
          "Q201=+3",
          "8 L X+1 ;half of key~",
          " width",
          "9 M3",
        ),
      ),
    ).toEqual([]));
  test("without ~ at all: refused at the first line that would be a block of its own, with the number of the cycle", () => {
    const lines = ["7 CYCL DEF 812  EPAUL LONG", "Q215=+0 ;A", "Q499 =+0 ;B", "Q493+50 ;C", "8 CYCL CALL"];
    expect(refusals(file(...lines), "tnc7")).toEqual([
      {
        line: 3,
        column: 1,
        block: 7,
        code: "listWithoutTilde",
        data: { list: "CYCL DEF 812", lines: 3 },
      },
    ]);
  });
  test.each([
    ["the header alone", ["7 CYCL DEF 200 B", "  Q200=+2 ~", "  Q201=-1"], "listWithoutTilde 7:3:3"],
    ["one line in the middle", ["7 CYCL DEF 200 B ~", "Q200=+2", "Q201=-1"], "listWithoutTilde 7:4:1"],
    ["a probe", ["7 TCH PROBE 421 HOLE", "Q263=+1", "8 M3"], "listWithoutTilde 7:3:1"],
    ["unnumbered", ["CYCL DEF 20 DATA", "Q1=-3 ;DEPTH"], "listWithoutTilde 1:3:1"],
    ["~ behind the last line", ["7 CYCL DEF 200 B ~", "Q200=+2 ~", "8 M3"], "tildeAtEnd 7:3:9"],
    ["~ before a block without number", ["7 CYCL DEF 200 B ~", "L X+3"], "tildeAtEnd 7:2:18"],
    ["no = in a list", ["7 CYCL DEF 200 B ~", "Q200=+2 ~", "Q201+3"], "equalsMissing 7:4:5"],
    ["no value in a list", ["7 CYCL DEF 200 B ~", "Q200= ;C"], "valueMissing 7:3:6"],
  ])("%s", (_, lines, where) => expect(found(file(...lines))).toEqual([where]));
  test.each([
    ["an assignment behind a cycle without parameters", ["CYCL DEF 801 RESET", "Q5 = 25", "Q1 = +3 ;STEPS"]],
    ["an assignment behind a whole list", ["CYCL DEF 200 B ~", "Q200=+2", "Q5 = 25", "Q7=+1"]],
    ["a numbered assignment", ["7 CYCL DEF 200 B", "8 Q200=+2 ;A"]],
    ["~ in a remark", ["; ~~~~", "7 * - ~", "L X+1"]],
    [
      "formulas and areas over several lines",
      ["5 Q2 = COS ( 3 * ~", "  SIN ( Q4 ) )", "6 CONTOUR DEF ~", "P1 = LBL 1 ~", "I2 = LBL 2"],
    ],
  ])("%s is taken", (_, lines) => expect(found(file(...lines))).toEqual([]));
});

describe("frame and labels", () => {
  test.each([
    ["nothing", "", ["beginMissing null:1:1", "endMissing null:1:1"]],
    ["no beginning", "1 M3\nEND PGM A MM", ["beginMissing 1:1:3"]],
    ["no end", "BEGIN PGM A MM\nM3", ["endMissing 1:2:1"]],
    ["no unit", "0 BEGIN PGM A\nEND PGM A MM", ["unitMissing 0:1:14"]],
    ["no name", "BEGIN PGM MM\nEND PGM A MM", ["nameMissing 0:1:11"]],
    ["other names", "BEGIN PGM A MM\n8 END PGM B MM", ["nameDiffers 8:2:11"]],
    ["a folder in the name", "BEGIN PGM A\\B MM\nEND PGM A\\B MM", ["nameCharacter 0:1:12", "nameCharacter 1:2:10"]],
    ["a block behind the end", "BEGIN PGM A MM\nEND PGM A MM\nM3\nM5", ["outsideProgram 2:3:1"]],
    ["two beginnings", "BEGIN PGM A MM\nBEGIN PGM A MM\nEND PGM A MM", ["outsideProgram 1:2:1"]],
    ["a label twice", file('LBL "A"', "LBL 0", "LBL 1", "LBL 0", '5 LBL "A"'), ["labelTwice 5:6:7"]],
    ["a label twice by its number", file("LBL 1", "LBL 01"), ["labelTwice 2:3:5"]],
  ])("%s", (_, text, where) => expect(found(text)).toEqual(where));
  test.each([
    ["remarks around it", "; post\n\n0  BEGIN PGM 2.5D FRÄSEN MM \n* - x\n1 END PGM 2.5D FRÄSEN MM\n;"],
    ["inches, CR LF, mixed line ends, a BOM", "\ufeff0 BEGIN PGM A INCH\r\n5 M3\n1 END PGM a INCH\r\n"],
    ["gaps and steps in numbers", "0 BEGIN PGM A MM\n10 M3\nM5\n7 END PGM A MM"],
    ["label 0 as often as wanted", file("LBL 0", "LBL 0")],
  ])("%s is taken", (_, text) => expect(found(text)).toEqual([]));
});

describe("openers with content of their own", () => {
  test.each([
    "PLANE SPATIAL SPA+0 SPB+Q27 SPC+0 TURN MB MAX F99999 SEQ- TABLE ROT",
    "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT TIP-TIP",
    "FUNCTION TURNDATA CORR-TCS:Z/X DZL:0.1 DXL:0.05",
    "FUNCTION TURNDATA BLANK LBL 20",
    "TCH PROBE 0.0 REF. PLANE Q5 X-",
    "CYCL DEF 7.1 #Q5",
    'CYCL DEF 207 1/4"-20 TAP',
    "CYCL DEF 14.1 KONTURLABEL1 /2",
    'SEL CORR-TABLE TCS "TNC:\\A.TCO"',
    "FN 16: F-PRINT TNC:\\A.A / TNC:\\B.TXT",
    "FN 18: SYSREAD Q30 = ID230 NR3 IDX3",
    'FN 38: SEND /"Q1: %F" / +Q1',
    'SQL BIND Q881 "T.NR',
    "CALL PGM TNC:\\work\\1.2.3.H",
    'DECLARE STRING QS1 = "A"',
    "TRANS DATUM AXIS X+40.5 IY-12.25",
    "FLT LEN 21.5 AN+30 CLSD- P1X+42.300 P1Y-5",
    "FSELECT2",
    "PATTERN DEF POS1 (X+25 Y+33.5 Z+0)",
    "POLARKIN AXES X Z C MODE:KEEP",
    "SPL X+1 K3X+0.123456789 K2X-1 F5",
    "CT X+5 Y+3 LIN_Z-6",
    "CP IPA-1800 IZ+5 DR- RL F50",
    "C+90 R0 F MAX",
    "DEP LT LEN 12.5 F100 M2",
    "CYCL CALL PAT F300 M3",
    "TOOL CALL  Z ;SET AXIS",
    "STOP M6",
    "RND R2,5 F0.08",
    "M11 M16 M140 MB MAX F5000",
    '*   - JOB: "9',
    '; " ~ ( 1.2.3',
    "",
  ])("%s", (line) => {
    expect(found(file(line))).toEqual([]);
    expect(found(file(`12 ${line}`))).toEqual([]);
  });
});
