import { expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { mainOf } from "./main-program.ts";

const pgm = (lines: string) => `0 BEGIN PGM S MM\n${lines}\nEND PGM S MM\n`;
/** Name and certainty of the program that runs. */
const main = (files: Readonly<Record<string, string>>) => {
  const list = Object.entries(files).map(([name, text]) => ({ name, text }));
  const { index, sure } = mainOf(list, parse);
  return `${list[index]?.name}${sure ? "" : "?"}`;
};

test.each([
  ["CALL PGM", "CALL PGM TNC:\\work\\cut"],
  ["SEL PGM", 'SEL PGM "CUT.H"\nCALL SELECTED PGM'],
  ["SEL CONTOUR", 'SEL CONTOUR "cut.h"'],
  ["CONTOUR DEF", 'CONTOUR DEF P1 = "CUT.H"'],
  ["cycle 12", "CYCL DEF 12.0 PGM CALL\nCYCL DEF 12.1 PGM TNC:\\CUT.H"],
  ["a text parameter", 'QS3 = "TNC:\\" || "CUT"\nCALL PGM QS3'],
  ["a declared contour", 'DECLARE CONTOUR QC1 = "CUT.H"'],
  ["the outline of a blank", 'FUNCTION TURNDATA BLANK "CUT.H"'],
])("the program that no other calls runs, by %s", (_, lines) => {
  expect(main({ "cut.h": pgm("L IX+1"), "points.tab": "BEGIN POINTS\n1 2", "whole.h": pgm(lines) })).toBe("whole.h");
});

test("a call over several programs, and one that calls itself", () => {
  expect(main({ "a.h": pgm("CALL PGM B"), "c.h": pgm("CALL PGM C"), "b.h": pgm("CALL PGM C") })).toBe("a.h");
});

test("of several uncalled programs the one that reaches most others runs, and is marked as unsure", () => {
  expect(main({ "x.h": pgm("L X+1"), "a.h": pgm("CALL PGM B"), "b.h": pgm("L X+2") })).toBe("a.h?");
  expect(main({ "x.h": pgm("L X+1"), "y.h": pgm("L X+2") })).toBe("x.h?");
});

test("of programs that call each other the first runs; without a program the first file", () => {
  expect(main({ "a.h": pgm("CALL PGM B"), "b.h": pgm("CALL PGM A") })).toBe("a.h?");
  expect(main({ "a.tab": "1 2 3", "b.txt": "hello" })).toBe("a.tab?");
});

test("a name in a comment is no call", () => {
  expect(main({ "a.h": pgm("L X+1 ;CALL PGM B"), "b.h": pgm("L X+2"), "c.h": pgm("CALL PGM A") })).toBe("c.h?");
  expect(main({ "a.h": pgm("L X+1 ;CALL PGM C"), "c.h": pgm("CALL PGM A") })).toBe("c.h");
});
