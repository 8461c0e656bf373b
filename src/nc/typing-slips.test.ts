import { expect, test } from "vitest";
import { parse } from "./parse.ts";
import { issuesOf } from "./program.ts";
import { lettersApart, spellingFix } from "./typing-slips.ts";

test.each([
  ["TOOL", "TOOL", 0],
  ["TOLL", "TOOL", 1],
  ["TRUN", "TURN", 1],
  ["FMX", "FMAX", 1],
  ["CALL", "CAL", 1],
  ["TURN", "MILL", 3],
])("%s and %s are %d letters apart", (a, b, apart) => {
  expect(lettersApart(a, b, 2)).toBe(apart);
  expect(lettersApart(b, a, 2)).toBe(apart);
});

/** The block with its spelling corrected; null where nothing is offered. */
function corrected(text: string): string | null {
  const issue = issuesOf(parse(text)).find(({ code }) => code === "notUnderstood" || code === "wordNotUnderstood");
  const fix = issue && spellingFix(issue, text, 0);
  return fix ? text.slice(0, fix.offset) + fix.text + text.slice(fix.offset + fix.length) : null;
}

test.each([
  ["3 TOLL CALL 1", "3 TOOL CALL 1"],
  ["3 TOOLCALL 1 Z S900", "3 TOOL CALL 1 Z S900"],
  ["3 TOLL CAL 1", "3 TOOL CALL 1"],
  ["CYCL CAL M3", "CYCL CALL M3"],
  ["12 FUNCTION MODE TRUN", "12 FUNCTION MODE TURN"],
  ["12 FUNTCION MODE TRUN", "12 FUNCTION MODE TURN"],
  ["FUNCTION TURNDATA SPIN VCONTS:ON VC:180 SMAX2500", "FUNCTION TURNDATA SPIN VCONST:ON VC:180 SMAX2500"],
  ["1 BLK FROM CYLINDER Z D60 L100 DIST+1", "1 BLK FORM CYLINDER Z D60 L100 DIST+1"],
  ["L X+60 Z+2 R0 FMX M303", "L X+60 Z+2 R0 FMAX M303"],
  ["CALL LBL1 REPP2", "CALL LBL1 REP2"],
  ["CALL LBLL 5", "CALL LBL 5"],
  ["CYCL DFE 812 SHOULDER ~\nQ215=+0 ~\nQ460=+2", "CYCL DEF 812 SHOULDER ~\nQ215=+0 ~\nQ460=+2"],
])("%s: %s", (typed, right) => {
  expect(corrected(typed)).toBe(right);
});

test.each(["L X+10 STRANGE", "HELLO WORLD", "G00 X10", "TOOL LIST 4", "FUNCTION PARAXCOMP MOVE X"])(
  "%s is no slip of a known word",
  (typed) => {
    expect(corrected(typed)).toBeNull();
  },
);
