import { describe, expect, test } from "vitest";
import { matchesIn, nextMatch } from "./text-search.ts";

const TEXT = `0 BEGIN PGM SHAFT MM
1 TOOL CALL 12 ; rough
12 L  X+12 Z-12
13 CYCL DEF 812 SHOULDER ~
  Q460=+2 ;SAFETY CLEARANCE ~
  Q12=+1
`;
const found = (sought: string) => matchesIn(TEXT, sought).map(({ from, to }) => TEXT.slice(from, to));

describe("occurrences", () => {
  test.each([
    ["", []],
    [" ", []],
    ["tool call", ["TOOL CALL"]],
    ["L X+12", ["L  X+12"]],
    ["X+1", ["X+1"]],
    [".", []],
    ["(", []],
    // All but the block number.
    ["12", ["12", "12", "12", "12", "12"]],
    ["12 L", ["12 L"]],
    ["q12", ["Q12"]],
    ["MM 1", []],
  ])("of %j", (sought, expected) => expect(found(sought)).toEqual(expected));
});

test("a number of DIN/ISO is none either", () => {
  expect(matchesIn("N10 G0 X10\n/ N20 M10\n", "10").map(({ from }) => from)).toEqual([8, 18]);
});

test("the next one goes around the end, the previous one around the start", () => {
  const matches = [5, 9, 20].map((from) => ({ from, to: from + 2 }));
  expect([0, 5, 6, 21].map((offset) => nextMatch(matches, offset))).toEqual([0, 0, 1, 0]);
  expect([0, 5, 6, 21].map((offset) => nextMatch(matches, offset, true))).toEqual([2, 2, 0, 2]);
  expect(nextMatch([], 3)).toBe(-1);
});

test("a text that is longer than any line is nowhere, however many words it has", () => {
  const words = "L X+1 ".repeat(10_000);
  expect(matchesIn(words, words)).toEqual([]);
});
