import { describe, expect, test } from "vitest";
import type { ProgramWork } from "../../app/document/work.ts";
import type { ComparedOperation } from "../../program/compare/by-operation.ts";
import type { BlockDifference } from "../../program/compare/compare.ts";
import { cycleIn, shownLines } from "./compare-words.ts";
import { comparedFiles, isListed, tallyOf, type ComparedFile } from "./compared.ts";

const PROGRAM = [
  "BEGIN PGM S MM",
  "FUNCTION MODE TURN",
  "* - FIRST",
  "TOOL CALL 1",
  "CYCL DEF 811 SHOULDER ~",
  " Q463=+2 ;DEPTH ~",
  " Q46=+7 ~",
  " Q478=+0.3 ~",
  " Q4=+1",
  "L X+60 Z+2 FMAX",
  "CYCL CALL",
  "* - SECOND",
  "TOOL CALL 3",
  "CYCL DEF 812 CYCLE ~",
  " Q463=+1 ~",
  " Q460=+2 ~",
  " Q215=+0",
  "L X+50 Z+2 FMAX",
  "CYCL CALL",
  "M30",
  "END PGM S MM",
  "",
].join("\n");
const SECOND = PROGRAM.slice(PROGRAM.indexOf("* - SECOND"), PROGRAM.indexOf("M30"));

const file = (name: string, text: string) => ({ name, text, encoding: "utf-8" as const });
const work = (text: string, files: ProgramWork["files"] = []): ProgramWork => ({ ...file("MAIN.h", text), files });
const compared = (one: ProgramWork, other: ProgramWork) =>
  comparedFiles(one, other).map((each) => [
    each.name,
    each.isMain,
    each.before.blocks.length > 0,
    each.after.blocks.length > 0,
    each.operations.some(({ differences }) => differences.length > 0),
  ]);

describe("the files of two works", () => {
  test("are compared by name, whatever its case; what is alike is left out, but the main program", () => {
    const [one, other] = [
      work(PROGRAM, [file("same.h", "L X+1\n"), file("gone.h", "L X+1\n"), file("Cut.h", "L X+1\n")]),
      work(PROGRAM, [file("new.h", "L X+2\n"), file("CUT.H", "L X+2\n"), file("SAME.H", "L X+1\n")]),
    ];
    expect(compared(one, other).map(([name, isMain, , , differs]) => [name, isMain, differs])).toEqual([
      ["MAIN.h", true, false],
      ["new.h", false, true],
      ["gone.h", false, true],
      ["CUT.H", false, true],
    ]);
    expect(compared(one, one)).toEqual([["MAIN.h", true, true, true, false]]);
  });

  test("are before and after in that order", () => {
    const [main] = comparedFiles(work(PROGRAM), work(PROGRAM.replace("Q463=+2", "Q463=+5")));
    const words = main?.operations.flatMap(({ differences }) => differences.flatMap((each) => each.words));
    expect(words).toEqual([{ name: "Q463", from: "2", to: "5" }]);
    expect(main && [main.numbers.before.length, main.partners.length]).toEqual([
      main?.before.blocks.length,
      main?.before.blocks.length,
    ]);
  });
});

describe("differences are counted", () => {
  const tally = (one: string, other: string) => {
    const counted = Object.entries(tallyOf(comparedFiles(work(one), work(other)))).filter(([, count]) => count > 0);
    return Object.fromEntries(counted);
  };
  test.each<[string, string, string, Readonly<Record<string, number>>]>([
    ["nothing", PROGRAM, PROGRAM, {}],
    [
      "two values of one block and one of another",
      PROGRAM,
      PROGRAM.replace("X+60 Z+2", "X+61 Z+3").replace("CALL 3", "CALL 5"),
      { values: 3 },
    ],
    ["a block", PROGRAM, PROGRAM.replace("M30", "L Z+90 FMAX\nM30"), { added: 1 }],
    ["a block less", PROGRAM.replace("M30", "L Z+90 FMAX\nM30"), PROGRAM, { removed: 1 }],
    [
      "an operation counts once, without its blocks but with its title",
      PROGRAM.replace(SECOND, ""),
      PROGRAM,
      { operationsAdded: 1, written: 1 },
    ],
    ["an operation less", PROGRAM, PROGRAM.replace(SECOND, ""), { operationsRemoved: 1, written: 1 }],
    [
      "an operation that moved, with its values",
      PROGRAM,
      PROGRAM.replace(SECOND, "").replace("* - FIRST", `${SECOND.replace("Q463=+1", "Q463=+1.5")}* - FIRST`),
      { values: 1, operationsMoved: 1, written: 2 },
    ],
    ["writing", PROGRAM, PROGRAM.replace("X+60 Z+2", "X+60.0  Z+2").replace(";DEPTH", ";OTHER"), { written: 2 }],
  ])("%s", (_, one, other, counts) => expect(tally(one, other)).toEqual(counts));
});

describe("an operation is listed", () => {
  const difference = (kind: BlockDifference["kind"]): BlockDifference => ({ kind, a: 0, b: 0, words: [] });
  const of = (
    outcome: ComparedOperation["outcome"],
    ...kinds: readonly BlockDifference["kind"][]
  ): ComparedOperation => ({
    outcome,
    a: null,
    b: null,
    differences: kinds.map(difference),
  });
  const effects = { passes: 1, infeed: 1, seconds: 1, residue: 0 };
  test.each<[string, ComparedOperation, boolean, boolean]>([
    ["not without a difference", of("kept"), false, false],
    ["that is added", of("added"), true, true],
    ["that moved", of("moved"), true, true],
    ["with a changed block", of("kept", "changed"), true, true],
    ["with a comment only where writing is asked for", of("kept", "note", "form"), false, true],
    ["with a comment and a changed block", of("kept", "note", "changed"), true, true],
  ])("%s", (_, operation, plain, withWriting) => {
    expect([isListed(operation, undefined, false), isListed(operation, undefined, true)]).toEqual([plain, withWriting]);
    const same = { before: effects, after: effects };
    expect(isListed(operation, same, false)).toBe(plain);
    expect(isListed(operation, { ...same, after: { ...effects, passes: 2 } }, false)).toBe(true);
  });
});

test("of a changed cycle the first line is shown, and the lines of exactly the changed values", () => {
  const shown = (change: (text: string) => string, side: "before" | "after") => {
    const [main] = comparedFiles(work(PROGRAM), work(change(PROGRAM))) as [ComparedFile];
    return main.operations.flatMap(({ differences }) =>
      differences.map((each) => shownLines(main[side], side === "before" ? each.a : each.b, each)),
    );
  };
  const one = (text: string) => text.replace("Q46=+7", "Q46=+8").replace("Q4=+1", "Q4=+2");
  expect(shown(one, "before")).toEqual([["CYCL DEF 811 SHOULDER", "Q46=+7", "Q4=+1"]]);
  expect(shown(one, "after")).toEqual([["CYCL DEF 811 SHOULDER", "Q46=+8", "Q4=+2"]]);
  expect(shown((text) => text.replace("X+50", "X+51"), "after")).toEqual([["L X+51 Z+2 FMAX"]]);
  // A comment that changed is shown with its block as it is written.
  expect(shown((text) => text.replace(";DEPTH", ";OTHER"), "after")[0]).toContain("Q463=+2 ;OTHER");
  const added = (text: string) => text.replace("M30", "L Z+90 FMAX\nM30");
  expect([shown(added, "before"), shown(added, "after")]).toEqual([[[]], [["L Z+90 FMAX"]]]);
});

test("the cycle of a block is that of its definition", () => {
  const [main] = comparedFiles(work(PROGRAM), work(PROGRAM)) as [ComparedFile];
  expect([null, 3, 4, 5, 99].map((index) => cycleIn(main.after, index))).toEqual([null, null, 811, null, null]);
});
