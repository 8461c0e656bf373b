import { Linter } from "eslint";
import { expect, test } from "vitest";
import { own } from "../scripts/lint/linear-patterns.mjs";

/** Whether the rule tells a line. */
const isTold = (line: string): boolean =>
  new Linter().verify(line, [{ plugins: { own }, rules: { "own/linear-patterns": "error" } }]).length > 0;

test.each([
  [String.raw`/\s+$/`],
  [String.raw`/^\s*\/?\s*x/`],
  [String.raw`/^(a+)+$/`],
  [String.raw`/^(a|a)*$/`],
  [String.raw`/^(a*)*b/`],
  [String.raw`/<[^>]*>/`],
  [String.raw`/\d+\.?\d*x/`],
  [String.raw`/^\s*x/m`],
  [String.raw`/a(?=.*b)/g`],
  [String.raw`/\d+(?![\d.])/`],
  [String.raw`/;.*$/`],
  [String.raw`const S = "\\s*"; new RegExp(S + S + "x")`],
  ["const S = String.raw`[ ]*`; RegExp(`^${S}${S}$`)"],
])("grows: %s", (line) => {
  expect(isTold(line)).toBe(true);
});

test.each([
  [String.raw`/\s+/g`],
  [String.raw`/^\s+/`],
  [String.raw`/(?<!\s)\s+$/`],
  [String.raw`/^\s*(?:\/\s*)?x/`],
  [String.raw`/(?<!\d)\d+(?![\d.])/`],
  [String.raw`/\b\w+x/`],
  [String.raw`/^[ \t]*x/m`],
  [String.raw`/;.*/`],
  [String.raw`/^\d{1,9}\d?x/`],
  [String.raw`/"[^"]*"?/`],
  [String.raw`new RegExp(text)`],
])("is linear: %s", (line) => {
  expect(isTold(line)).toBe(false);
});
