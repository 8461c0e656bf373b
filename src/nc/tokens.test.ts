import * as fc from "fast-check";
import { expect, test } from "vitest";
import { tokensOf } from "./tokens.ts";

const shown = (line: string) => tokensOf(line).map((t) => `${t.kind}:${line.slice(t.from, t.to)}`);

test("the tokens of usual blocks", () => {
  expect(shown("12 L  X+75 IZ-0.5 R0 FMAX  M303 ;there")).toEqual([
    "number:12",
    "keyword:L",
    "word:X",
    "value:+75",
    "word:IZ",
    "value:-0.5",
    "word:R0",
    "word:FMAX",
    "word:M",
    "value:303",
    "comment:;there",
  ]);
  expect(shown("9 CYCL DEF 207 NAME, LONG ~")).toEqual([
    "number:9",
    "keyword:CYCL DEF",
    "value:207",
    "name:NAME,",
    "name:LONG",
    "mark:~",
  ]);
  expect(shown("Q493=+Q7 ;END ~")).toEqual(["parameter:Q493", "mark:=", "mark:+", "parameter:Q7", "comment:;END ~"]);
  expect(shown("3 * - ROUGHING")).toEqual(["number:3", "structure:* - ROUGHING"]);
  expect(shown('/4 CALL LBL "A B" REP2')).toEqual([
    "number:/4",
    "keyword:CALL LBL",
    'string:"A B"',
    "word:REP",
    "value:2",
  ]);
});

test("any line is split in order and without overlaps", () => {
  fc.assert(
    fc.property(fc.string({ unit: "binary" }), (line) => {
      let at = 0;
      for (const t of tokensOf(line)) {
        expect(t.from).toBeGreaterThanOrEqual(at);
        expect(t.to).toBeGreaterThan(t.from);
        at = t.to;
      }
      expect(at).toBeLessThanOrEqual(line.length);
    }),
    { numRuns: 1000 },
  );
});
