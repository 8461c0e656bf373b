import { describe, expect, test } from "vitest";
import { LONGEST_LINE } from "../longest-line.ts";
import { parse } from "../parse.ts";
import { issuesOf } from "../program.ts";
import { LAYOUTS } from "../style.ts";
import { isIsoText } from "./lines.ts";
import { ENGLISH_NAMES } from "./names.ts";
import { isoProgramText } from "./print-iso.ts";
import { klartextOfIso } from "./read-iso.ts";

const style = LAYOUTS.tnc7;
const klartext = (text: string) => klartextOfIso(text, style);
const lines = (...l: string[]) => l.map((line) => `${line}\n`).join("");
/** Blocks without frame and without numbers, for cases of one thing. */
const bodies = (text: string) =>
  klartext(text)
    .text.trimEnd()
    .split("\n")
    .map((line) => line.replace(/^\d+ /, ""));

describe("programs as other people write them", () => {
  test("modal, counted in tens, with G words in any order", () => {
    const text = lines(
      "%S525 G71 *",
      "N10 G30 G17 X+0 Y+0 Z-20 *",
      "N20 G31 G90 X+100 Y+100 Z+0 *",
      "N30 G99 T12 L-25 R+20 *",
      "N40 T12 G17 S1000 *",
      "N50 G90 G40 G00 Z+100 M06 *",
      "N60 X+30 Y-30 *",
      "N70 Z-15 M03 *",
      "N80 G41 G01 X+50 Y+0 F100 *",
      "N90 X+10 Y+40 *",
      "N100 G06 X+50 Y+50 *",
      "N110 G01 X+100 *",
      "N120 G00 G40 X+130 Y+70 *",
      "N130 Z+100 M02 *",
      "N99999 %S525 G71 *",
    );
    expect(isIsoText(text)).toBe(true);
    const read = klartext(text);
    expect(read.issues).toEqual([]);
    expect(read.text).toBe(
      lines(
        "0 BEGIN PGM S525 MM",
        "10 BLK FORM 0.1 Z X+0 Y+0 Z-20",
        "20 BLK FORM 0.2 X+100 Y+100 Z+0",
        "30 TOOL DEF 12 L-25 R+20",
        "40 TOOL CALL 12 Z S1000",
        "50 L Z+100 R0 FMAX M6",
        "60 L X+30 Y-30 FMAX",
        "70 L Z-15 FMAX M3",
        "80 L X+50 Y+0 RL F100",
        "90 L X+10 Y+40",
        "100 CT X+50 Y+50",
        "110 L X+100",
        "120 L X+130 Y+70 R0 FMAX",
        "130 L Z+100 FMAX M2",
        "140 END PGM S525 MM",
      ),
    );
  });

  test("without blanks, without stars, in small letters, with commas", () => {
    const text = lines(
      "%teil7 g70",
      "n5t0g17",
      "n10t5g18s1200dl+0,05",
      "n15g00g40g90x+20,5z+2m3",
      "n20z-1,25",
      "n25g01g91z-0,5f80",
      "n30x-q5g90",
      "n35g02x+10z-5r-2,5",
      "n99999999%teil7g70",
    );
    expect(isIsoText(text)).toBe(true);
    const read = klartext(text);
    expect(read.issues).toEqual([]);
    expect(read.text).toBe(
      lines(
        "0 BEGIN PGM teil7 INCH",
        "5 TOOL CALL 0 Z",
        "10 TOOL CALL 5 Y S1200 DL+0.05",
        "15 L X+20.5 Z+2 R0 FMAX M3",
        "20 L Z-1.25 FMAX",
        "25 L IZ-0.5 F80",
        "30 L X-Q5",
        "35 CR X+10 Z-5 R-2.5 DR-",
        "40 END PGM teil7 INCH",
      ),
    );
  });

  test("centres in a block of their own, in the arc, relative, and the last position", () => {
    expect(
      bodies(
        lines(
          "G01 X+5 Y+45 F200",
          "I+45 J+45",
          "G03 X+40.5 Y+12.75",
          "X+85 Y+45",
          "G02 I+50.5 J+0 X+5 Y+45",
          "G05 X+6 Y+44.5",
          "G91 I+10",
          "G90 J-10 G91 I+2",
          "G29",
          "G12 I+1 H+90",
          "I-1 K-2 M8",
        ),
      ),
    ).toEqual([
      "L X+5 Y+45 F200",
      "CC X+45 Y+45",
      "C X+40.5 Y+12.75 DR+",
      "C X+85 Y+45 DR+",
      "CC X+50.5 Y+0",
      "C X+5 Y+45 DR-",
      "C X+6 Y+44.5 DR-",
      "CC IX+10",
      "CC Y-10 IX+2",
      "CC",
      "CC IX+1",
      "CP IPA+90 DR-",
      "CC IX-1 IZ-2 M8",
    ]);
  });

  test("polar, with a helix", () => {
    expect(
      bodies(
        lines(
          "N10 I+25 K+25 *",
          "N20 G11 G42 R+20 H+0 F250 M3 *",
          "N30 G13 H+180 *",
          "N40 G16 R+30 H+30 *",
          "N50 G10 G40 G90 R+60 G91 H-15.5 *",
          "N60 H-15.5 *",
          "N70 G13 G91 H+1080 Z-4.5 *",
          "N80 G15 H+10 *",
        ),
      ),
    ).toEqual([
      "CC X+25 Z+25",
      "LP PR+20 PA+0 RR F250 M3",
      "CP PA+180 DR+",
      "CTP PR+30 PA+30",
      "LP PR+60 IPA-15.5 R0 FMAX",
      "LP IPA-15.5 FMAX",
      "CP IZ-4.5 IPA+1080 DR+",
      "CP IPA+10 DR+",
    ]);
  });

  test("subprograms, repeats, jumps, calls of programs", () => {
    expect(
      bodies(
        lines(
          "N1 L1,0 *",
          'N2 L"IN",3 *',
          "N3 L 7 , Q5 *",
          "N4 L2",
          "N5 G98 L1 *",
          'N6 G98 L"IN" *',
          "N7 G98 L0 *",
          "N8 D09 P01 +Q1 P02 +Q03 P03 10 *",
          'N9 D12P01+Q5P02+0P03"END" *',
          "N10 D00 Q05 P01 +60 *",
          "N11 d2q1p01-q2p02-5",
          "N12 Q1 = Q05 + 3 *",
          "N13 %TNC:\\SUB\\A.I *",
          "N14 D14 P01 1000 *",
        ),
      ),
    ).toEqual([
      "CALL LBL 1",
      'CALL LBL "IN" REP 3',
      "CALL LBL 7 REP Q5",
      "CALL LBL 2",
      "LBL 1",
      'LBL "IN"',
      "LBL 0",
      "FN 9: IF +Q1 EQU +Q3 GOTO LBL 10",
      'FN 12: IF +Q5 LT +0 GOTO LBL "END"',
      "FN 0: Q5 = +60",
      "FN 2: Q1 = -Q2 - -5",
      "Q1 = Q05 + 3",
      "CALL PGM TNC:\\SUB\\A.I",
      "FN 14: ERROR=1000",
    ]);
  });

  test("cycles on one line or several, with and without continuation mark and labels", () => {
    const list = ["CYCL DEF 256 STUD ~", "Q218=+60 ;SIDE ~", "Q424=+75.5"];
    const bare = ["CYCL DEF 256 ~", "Q218=+60 ~", "Q424=+75.5"];
    expect(bodies("N40 G256 Q218=+60 Q424=+75,5 *\nN50 G79 M3 *\n")).toEqual([...bare, "CYCL CALL M3"]);
    expect(bodies("N40 G256Q218=+60Q424+75.5\n")).toEqual(bare);
    expect(bodies("N40 G256 STUD ~\n  Q218=+60 ;SIDE ~\n  Q424=+75.5 *\nN50 G79 *\n")).toEqual([...list, "CYCL CALL"]);
    expect(bodies("G256 STUD\nQ218=+60 ;SIDE\nQ424=+75.5\nG79\n")).toEqual([...list, "CYCL CALL"]);
    expect(bodies("N40 G256 *\nQ218=+60 *\nQ424=+75.5 *\nN50 Q1=+5 *\n")).toEqual([...bare, "Q1 = 5"]);
    // Comments of heads become blocks, the comment of a line belongs to its last parameter.
    expect(bodies("N40 G256 ;head ~\nQ218=+60 *\nN50 G257 ;all *\nN60 G258 Q5=+1 ;last *\n")).toEqual([
      ";head",
      "CYCL DEF 256 ~",
      "Q218=+60",
      ";all",
      "CYCL DEF 257",
      "CYCL DEF 258 ~",
      "Q5=+1 ;last",
    ]);
    // An assignment in a program without numbers is no parameter of the preceding cycle.
    expect(bodies("G256 Q218=+60\nQ1=+5\n")).toEqual(["CYCL DEF 256 ~", "Q218=+60", "Q1 = 5"]);
  });

  test("names and labels come from the caller", () => {
    const names = {
      cycle: (n: number) => `C${n}`,
      label: (n: number, q: string) => (q === "Q218" ? `${n} ${q}` : null),
      contour: { title: "KONTUR", label: "KONTURLABEL" },
    };
    expect(
      klartextOfIso(
        "N1 G256 Q218=+60 Q424=+2 *\nN2 G37 P01 5 P02 12 *\nN9 G04 F0.5 *\n",
        { ...style, decimal: "," },
        names,
      ).text,
    ).toBe(
      lines(
        "1 CYCL DEF 256 C256 ~",
        "Q218=+60 ;256 Q218 ~",
        "Q424=+2",
        "2 CYCL DEF 14.0 KONTUR",
        "3 CYCL DEF 14.1 KONTURLABEL5 /12",
        "9 CYCL DEF 9.0 C9",
        "10 CYCL DEF 9.1 DWELL 0.5",
      ),
    );
  });

  test("comments, structure, marks and Klartext in between", () => {
    expect(
      klartext(
        lines(
          "; head *",
          "%A G71 ;first *",
          "/N10 G00 X+5 ;to the side *",
          "N20 / L X+7 FMAX *",
          "",
          "N30 * - PART *",
          "N40 ;*** text ***",
          "N50 G90 ;only a mode *",
          "N60 FUNCTION MODE TURN *",
          "N70 APPR LT X+20 Z+2 LEN5 RL F0.2 *",
          "N99999999 %A G71 *",
        ),
      ).text,
    ).toBe(
      lines(
        "; head",
        "0 BEGIN PGM A MM ;first",
        "/10 L X+5 FMAX ;to the side",
        "/20 L X+7 FMAX",
        "",
        "30 * - PART",
        "40 ;*** text ***",
        "50 ;only a mode",
        "60 FUNCTION MODE TURN",
        "70 APPR LT X+20 Z+2 LEN5 RL F0.2",
        "80 END PGM A MM",
      ),
    );
  });

  test("a feed at rapid applies to the next feed block, and a speed is a tool call without a tool", () => {
    expect(
      bodies(
        lines(
          "G00 X+5 F300",
          "Z-1",
          "G25 R2",
          "G01 Z-2",
          "Z-3",
          "S800 M3",
          "G01 X+9 S900 F10",
          "G00 F100 Z+5",
          "G01 X+1 F20",
          "T7 M6 G17 S50",
        ),
      ),
    ).toEqual([
      "L X+5 FMAX",
      "L Z-1 FMAX",
      "RND R2",
      "L Z-2 F300",
      "L Z-3",
      "TOOL CALL S800",
      "M3",
      "TOOL CALL S900",
      "L X+9 F10",
      "L Z+5 FMAX",
      "L X+1 F20",
      "TOOL CALL 7 Z S50",
      "M6",
    ]);
  });
});

describe("what is not understood", () => {
  const findings = (text: string) =>
    klartext(text).issues.map(
      (i) => `${i.code} ${i.severity} N${i.number} ${i.line}:${i.column} ${JSON.stringify(i.data)}`,
    );
  test.each([
    ["N10 X+5 *", "isoPathMissing error N10 1:5 {}"],
    ["N10 G00 X+5 *\nN20 G26 R5 *", 'isoWordNotUnderstood error N20 2:5 {"word":"G26"}'],
    ["N20 G01 X+5 G43 F1 *", 'isoWordNotUnderstood error N20 1:13 {"word":"G43"}'],
    ["N20 G05 X+5 *", 'isoDirectionMissing error N20 1:5 {"word":"G05"}'],
    ["N20 G01 X Z+5 *", 'isoValueMissing error N20 1:9 {"word":"X"}'],
    ["N20 G01 X+5 G18 *", 'isoPlaneLeftOut warning N20 1:13 {"word":"G18"}'],
    ["N20 G01 X+5 R4 *", 'isoBlockNotUnderstood error N20 1:5 {"text":"G01 X+5 R4"}'],
    ["N20 G01 ?? X+5 *", 'isoBlockNotUnderstood error N20 1:5 {"text":"G01 ?? X+5"}'],
    ["  G25 R2 X+5", 'isoBlockNotUnderstood error Nnull 1:3 {"text":"G25 R2 X+5"}'],
    ["N20 G98 L-1 *", 'isoBlockNotUnderstood error N20 1:5 {"text":"G98 L-1"}'],
    ["N20 D01 Q1 P01 +5 *", 'isoBlockNotUnderstood error N20 1:5 {"text":"D01 Q1 P01 +5"}'],
    ["N20 D19 P01 +5 *", 'isoBlockNotUnderstood error N20 1:5 {"text":"D19 P01 +5"}'],
    ["N20 G37 P01 *", 'isoBlockNotUnderstood error N20 1:5 {"text":"G37 P01"}'],
    ["N20 G200 X+5 *", 'isoBlockNotUnderstood error N20 1:5 {"text":"G200 X+5"}'],
    ["N20 T5 X+3 *", 'isoBlockNotUnderstood error N20 1:5 {"text":"T5 X+3"}'],
    ['N20 %:PAT: "A" *', 'isoBlockNotUnderstood error N20 1:5 {"text":"%:PAT: \\"A\\""}'],
  ])("%j", (text, finding) => expect(findings(text)).toEqual([finding]));

  test.each([" Q1", ";"])("a line longer than a block can be: G01 X+2%s and so on", (more) => {
    const long = `N20 G01 X+2${more.repeat(LONGEST_LINE)}`;
    const { text, issues } = klartext(lines("%S G71 *", "N10 G01 X+1 *", long, "N30 G01 X+4 *", "N99999 %S G71 *"));
    expect(text.split("\n")[2]).toContain(long.slice(4));
    expect(issues.map(({ code, line }) => `${code} ${line}`)).toEqual(["isoBlockNotUnderstood 3"]);
  });
  test("a kept block is unknown in Klartext too, and keeps its modal effect", () => {
    const { text } = klartext(
      lines("N10 G00 X+5 *", "N20 G01 X+4 G43 *", "N30 X+3 *", "N40 X+2 FOO *", "N50 G26 R5 *"),
    );
    expect(text).toBe(lines("10 L X+5 FMAX", "20 G01 X+4 G43", "30 L X+3", "40 ISO X+2 FOO", "50 G26 R5"));
    expect(parse(text).blocks.map((b) => b.statement.kind)).toEqual(["path", "unknown", "path", "unknown", "unknown"]);
    expect(isoProgramText(parse(text)).text).toBe(
      lines("N10 G00 G90 X+5 *", "N20 G01 X+4 G43 *", "N30 G01 G90 X+3 *", "N40 X+2 FOO *", "N50 G26 R5 *"),
    );
  });
});

describe("numbers of blocks", () => {
  const numbers = (text: string) => parse(klartext(text).text).blocks.map((b) => b.number);
  test("those of the file, where they ascend and leave room", () => {
    expect(numbers(lines("%A G71 *", "N10 M8 *", "N20 G37 P01 2 *", "N30 M9 *", "N99999999 %A G71 *"))).toEqual([
      0, 10, 20, 21, 30, 40,
    ]);
    expect(numbers(lines("%A G71 *", "N1 M8 *", "G37 P01 2 *", "N4 M9 *"))).toEqual([0, 1, 2, 3, 4]);
  });
  test.each([
    lines("%A G71 *", "N10 M8 *", "N5 M9 *", "N99999999 %A G71 *"),
    lines("%A G71 *", "N1 M8 *", "N1 M9 *", "N99999999 %A G71 *"),
    lines("%A G71 *", "N0 M8 *", "N1 M9 *", "N99999999 %A G71 *"),
  ])("else they are counted from 0, which is findings", (text) => {
    expect(numbers(text)).toEqual([0, 1, 2, 3]);
    expect(klartext(text).issues).toMatchObject([
      { code: "isoBlocksRecounted", severity: "info", number: null, line: 1, column: 1 },
    ]);
  });
  test("a file without numbers is numbered without a finding", () => {
    expect(klartext("%A G71\nM8\n%A G71\n")).toEqual({
      text: lines("0 BEGIN PGM A MM", "1 M8", "2 END PGM A MM"),
      issues: [],
    });
  });
});

describe("the text that is printed", () => {
  test("one block per line with its Klartext number, in the line ends of the program", () => {
    const text =
      "0 BEGIN PGM A MM\r\n/1 L X+5 FMAX ;out\r\n\r\n; note\r\n2 FUNCTION MODE TURN\r\n3 CYCL DEF 7.0 D\r\n4 CYCL DEF 7.1 X+1\r\n" +
      "7 M30\r\n8 END PGM A MM\r\n";
    const { text: iso, untranslated } = isoProgramText(parse(text));
    expect(iso).toBe(
      "%A G71 *\r\n/N1 G00 G90 X+5 ;out *\r\n\r\n; note *\r\nN2 FUNCTION MODE TURN *\r\nN3 G54 G90 X+1 *\r\nN7 M30 *\r\n" +
        "N99999999 %A G71 *\r\n",
    );
    expect(untranslated).toEqual([{ index: 4, number: 2 }]);
    expect(klartextOfIso(iso, { ...style, newLine: "\r\n" }, { ...ENGLISH_NAMES, cycle: () => "D" }).text).toBe(text);
  });
  test("a program without numbers gets them", () => {
    expect(isoProgramText(parse("BEGIN PGM A INCH\nM8\n;c\nM9\nEND PGM A INCH\n")).text).toBe(
      "%A G70 *\nN1 M8 *\n;c *\nN2 M9 *\nN99999999 %A G70 *\n",
    );
    expect(isoProgramText(parse(""))).toEqual({ text: "", untranslated: [] });
  });
  test("what comes back is Klartext without findings of the reader", () => {
    const { text } = klartext("%A G71 *\nN1 G00 G40 G90 X+20 Z+2 *\nN2 G01 Z-5 F0.2 *\nN3 M30 *\nN99999999 %A G71 *\n");
    expect(issuesOf(parse(text))).toEqual([]);
  });
});

test.each([
  ["\ufeff\n; c\n%A G71 *\n", true],
  ["%A G70", true],
  ["N10 G00 X+5\nN20 X+7 *\nN30 M30 *\n", true],
  ["G00 X5\nG01 Z-1\nX7\n", true],
  ["", false],
  ["; only a comment\n", false],
  ["0 BEGIN PGM A MM\n1 G00 X+5\n2 G01\n3 G02\n", false],
  ["N10 L X+5\nN20 L Z-1 FMAX\n", false],
  ["%\nO1000\nX5\n", false],
  ["T\tNAME\n1\tA\n", false],
])("%j is a DIN/ISO text: %s", (text, is) => expect(isIsoText(text)).toBe(is));
