import * as fc from "fast-check";
import { describe, expect, test } from "vitest";
import { klartext } from "./blocks/klartext.ts";
import { numberedFromZero, renumbered, withBlock, withInserted, withNumbers, withoutBlocks } from "./edit.ts";
import { parse } from "./parse.ts";
import { print } from "./program.ts";
import type { Statement } from "./statement.ts";
import type { AxisWord, CycleParameter, Value } from "./words.ts";

const samples = Object.values(
  import.meta.glob<string>("../../tests/programs/*.h", { query: "?raw", import: "default", eager: true }),
);

const line = (...axes: AxisWord[]): Statement => ({
  kind: "path",
  path: "L",
  words: { axes, functions: [], feed: "max" },
});
const x = (value: Value): AxisWord => ({ axis: "X", value, incremental: false });

/** Changes one value of the cycle in block `index`. */
function set(text: string, index: number, q: string, value: CycleParameter["value"]): string {
  const program = parse(text);
  const s = program.blocks[index]?.statement;
  if (s?.kind !== "cycle") throw new Error("no cycle");
  return print(
    withBlock(program, index, { ...s, parameters: s.parameters.map((p) => (p.q === q ? { ...p, value } : p)) }),
  );
}

describe("one block changes", () => {
  test("a value of a cycle: only its characters", () => {
    const text =
      "0 BEGIN PGM A MM\r\n  5 CYCL DEF 200 BOHREN ~\r\n    Q200=5   ;ABSTAND ~\r\n    Q201=-21,732 ;TIEFE\r\n6 L X10 Y10\r\n";
    expect(set(text, 1, "Q201", -3.5)).toBe(text.replace("-21,732", "-3,5"));
    expect(set(text, 1, "Q200", 7)).toBe(text.replace("Q200=5 ", "Q200=7 "));
  });
  test("a misprint in the changed line is corrected, others stay", () => {
    const text = "1 CYCL DEF 99 N\nQ491+50 ;A\nQ492+1 ;B\nQ499 =+0 ;C\n";
    expect(set(text, 0, "Q491", 20)).toBe("1 CYCL DEF 99 N\nQ491=+20 ;A\nQ492+1 ;B\nQ499 =+0 ;C\n");
  });
  test("a feed with a blank between F and value", () => {
    const text = "1 CYCL DEF 99 N\nQ478=F AUTO ;A\nQ488= F 0.2 ;B\nQ499=+1 ;F AUTO\n";
    expect(set(text, 0, "Q478", 0.25)).toBe(text.replace("=F AUTO", "=+0.25"));
    expect(set(text, 0, "Q488", "max")).toBe(text.replace("F 0.2", "FMAX"));
    expect(set(text, 0, "Q499", 2)).toBe(text.replace("+1", "+2"));
  });
  test("an empty value: the blank before its label stays there", () => {
    const text = "1 CYCL DEF 99 N ~\nQ491= ;A ~\nQ492=;B ~\nQ493 =\n";
    expect(set(text, 0, "Q491", 70)).toBe(text.replace("Q491= ", "Q491=+70 "));
    expect(set(text, 0, "Q492", -15)).toBe(text.replace("Q492=", "Q492=-15"));
    expect(set(text, 0, "Q493", 1)).toBe(text.replace("Q493 =", "Q493 =+1"));
  });
  test("in the style around it: two blanks, comma, no plus, F MAX", () => {
    const wide = "7 L  X+75 Z-20\r\n8 L  X+50 ;here\r\n";
    expect(print(withBlock(parse(wide), 1, line(x(12.5))))).toBe("7 L  X+75 Z-20\r\n8 L  X+12.5 FMAX ;here\r\n");
    const cam = "7 L X10 Y10,5 R0 F MAX\n8 L Z5 F MAX\n";
    expect(print(withBlock(parse(cam), 1, line(x(12.5))))).toBe("7 L X10 Y10,5 R0 F MAX\n8 L X12,5 F MAX\n");
  });
  test.each([
    ["L  X+50.000   Z-3,5 R0 F0,2 M8", "X", 7.25, "L  X+7,25   Z-3,5 R0 F0,2 M8"],
    ["L Z-3.50 X+50.0 R0 FMAX M08 ;d,h", "X", -1, "L Z-3.50 X-1 R0 FMAX M08 ;d,h"],
    ["l x+50 z-3 fmax", "Z", null, "l x+50 fmax"],
    ["L X+50.0  R0 F.2", "Z", -3, "L X+50.0 Z-3  R0 F.2"],
    ["CALL LBL 7 REP 2/2", "label", "71", "CALL LBL 71 REP 2/2"],
    ["CP IPA+360.0 IZ+5 DR+", "Z", 4, "CP IPA+360.0 IZ+4 DR+"],
    ["FC DR+ R15.0 CCX+20 CCZ-5", "radius", 3, "FC DR+ R+3 CCX+20 CCZ-5"],
    [
      "BLK FORM CYLINDER Z D80.0 L100 DIST+0 DI20.00 ; ROH",
      "length",
      90,
      "BLK FORM CYLINDER Z D80.0 L90 DIST+0 DI20.00 ; ROH",
    ],
    ["TOOL CALL 2 Z S 1200 F0.20 DL+0.05", "tool", 3, "TOOL CALL 3 Z S 1200 F0.20 DL+0.05"],
  ])("%s: only the characters of %s", (text, id, value, expected) => {
    const program = parse(`7 ${text}\r\n8 L Z+2\r\n`);
    const s = program.blocks[0]?.statement;
    const field = s && klartext.fields(s).find((each) => each.id === id);
    if (!s || !field || !("put" in field)) throw new Error("no such word");
    const put = field.put as (from: Statement, to: unknown) => Statement;
    expect(print(withBlock(program, 0, put(s, value)))).toBe(`7 ${expected}\r\n8 L Z+2\r\n`);
  });
  test("the same words in another order of properties change nothing", () => {
    const program = parse("7 APPR LT X+60.00 Z+2 LEN4.0 RL F0.2\n");
    const s = program.blocks[0]?.statement;
    if (!s) throw new Error("no block");
    const turned = Object.fromEntries(Object.entries(s).toReversed()) as unknown as Statement;
    expect(print(withBlock(program, 0, turned))).toBe(print(program));
  });
  test("skip mark and number stay as written", () =>
    expect(print(withBlock(parse("/ 7  L X+1\n"), 0, line(x(2))))).toBe("/ 7  L X+2 FMAX\n"));
});

describe("blocks come and go", () => {
  const text = "8 L X+1\n9 ; note\n10 L X+2\n; unnumbered\n11 L X+3";
  test("insert renumbers the following blocks", () =>
    expect(print(withInserted(parse(text), 1, line(x(9))))).toBe(
      "8 L X+1\n9 L X+9 FMAX\n10 ; note\n11 L X+2\n; unnumbered\n12 L X+3",
    ));
  test("append after a last line without a line end", () =>
    expect(print(withInserted(parse(text), 5, line(x(9))))).toBe(`${text}\n12 L X+9 FMAX\n`));
  test("delete renumbers the following blocks", () =>
    expect(print(withoutBlocks(parse(text), 1))).toBe("8 L X+1\n9 L X+2\n; unnumbered\n10 L X+3"));
  test("correct numbers are left alone", () => {
    const program = parse(text);
    expect(print(renumbered(program, 1))).toBe(text);
  });
});

const statements = fc.constantFrom<Statement[]>(
  line(x(1.25)),
  { kind: "label", label: 7 },
  { kind: "comment", text: " new" },
  {
    kind: "functions",
    words: { axes: [], functions: [3] },
  },
);

test("an edit touches no other block, and the text reads back as edited", () => {
  fc.assert(
    fc.property(
      fc.constantFrom(...samples),
      fc.double({ min: 0, max: 0.999, noNaN: true }),
      statements,
      fc.constantFrom("\n", "\r\n"),
      (sample, where, statement, end) => {
        const program = parse(sample.replaceAll("\n", end));
        const index = Math.floor(where * program.blocks.length);
        const edited = withBlock(program, index, statement);
        expect(edited.blocks).toHaveLength(program.blocks.length);
        edited.blocks.forEach((b, i) => {
          if (i !== index) expect(b).toBe(program.blocks[i]);
        });
        expect(edited.blocks[index]?.statement).toEqual(statement);
        expect(parse(print(edited)).blocks.map((b) => b.statement)).toEqual(edited.blocks.map((b) => b.statement));
        expect(withBlock(edited, index, statement)).toBe(edited);
      },
    ),
    { numRuns: 2000 },
  );
});

describe("numbers", () => {
  test.each([
    ["gaps and repetitions", "0 BEGIN PGM A MM\n7 L X+1\n7 L X+2\n", "0 BEGIN PGM A MM\n1 L X+1\n2 L X+2\n"],
    ["missing ones, also of comments", "BEGIN PGM A MM\n; a\n\n  /L X+1\n", "0 BEGIN PGM A MM\n1 ; a\n\n  /2 L X+1\n"],
    [
      "only the first line of a list",
      "5 CYCL DEF 200 A ~\n  Q200=+2\n6 L X+1\n",
      "0 CYCL DEF 200 A ~\n  Q200=+2\n1 L X+1\n",
    ],
    ["tens, with N", "N10 BEGIN PGM A MM\nL X+1\nN20 L X+2", "N0 BEGIN PGM A MM\nN1 L X+1\nN2 L X+2"],
  ])("from 0 in steps of 1: %s", (_, before, after) => {
    expect(print(numberedFromZero(parse(before)))).toBe(after);
    expect(numberedFromZero(parse(after)).blocks.map((b) => b.number)).toEqual(
      parse(after).blocks.map((b) => b.number),
    );
  });

  test.each([
    [
      "a typed block, and those behind it",
      "0 BEGIN PGM A MM\nL X+1\n1 L X+2\n",
      "0 BEGIN PGM A MM\n1 L X+1\n2 L X+2\n",
    ],
    ["a comment, but no blank line", "0 BEGIN PGM A MM\n\n; a\n1 L X+2\n", "0 BEGIN PGM A MM\n\n1 ; a\n2 L X+2\n"],
    ["nothing in a program without numbers", "BEGIN PGM A MM\nL X+1\n", "BEGIN PGM A MM\nL X+1\n"],
    ["the line end stays", "0 BEGIN PGM A MM\r\n L X+1\r\n", "0 BEGIN PGM A MM\r\n1 L X+1\r\n"],
  ])("of blocks without one: %s", (_, before, after) => {
    const program = parse(before);
    expect(print(withNumbers(program, 1, program.blocks.length - 1))).toBe(after);
  });

  test("every sample is numbered as reading the numbered text again says", () => {
    for (const text of samples) {
      const made = numberedFromZero(parse(text));
      expect(made.blocks.filter((b) => b.number !== null).map((b) => b.number)).toEqual([
        ...made.blocks.filter((b) => b.number !== null).keys(),
      ]);
      expect(parse(print(made)).blocks).toEqual(made.blocks);
    }
  });
});
