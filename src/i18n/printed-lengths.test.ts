import { expect, test } from "vitest";
import { issue } from "../kernel/plan/issue.ts";
import { programIssue } from "../program/state/issue.ts";
import { lengthsIn } from "./lengths.ts";
import { message } from "./message.ts";
import { printedLengths } from "./printed-lengths.ts";

const inch = lengthsIn("en", "inch", 25.4);

test.each([
  [
    issue("deeperThanInfeed", "warning", { depth: 5.08, allowed: 2.54, pass: 2 }),
    { depth: "length", allowed: "length" },
  ],
  [
    issue("materialLeft", "warning", { reason: "mainEdge", area: 6, x: 50, z: -4 }),
    { area: "area", x: "length", z: "length" },
  ],
  [issue("tooManyPasses", "error", { passes: 4000, most: 2000, nearest: 0.5 }), { nearest: "length" }],
  [issue("elementContradicts", "error", { element: 1, quantity: "angle", given: 30, nearest: 45 }, "contour"), {}],
  [
    issue("elementContradicts", "error", { element: 1, quantity: "radius", given: 30, nearest: 45 }, "contour"),
    {
      given: "length",
      nearest: "length",
    },
  ],
  [
    issue("runInShort", "warning", { runIn: 4, needed: 5, speed: 800, nearest: 5 }),
    {
      runIn: "length",
      needed: "length",
      nearest: "length",
    },
  ],
  [programIssue("pitchOfTap", "warning", { pitch: 2, tap: 1.5 }), { pitch: "length", tap: "length" }],
])("the sentence of %o says which of its numbers are lengths", (found, expected) => {
  expect(Object.fromEntries(printedLengths(found))).toEqual(expected);
});

test("a value is a length where its parameter measures one", () => {
  const found = issue("outOfRange", "error", { value: 1200, min: 0, max: 999 }, "Q460");
  expect([...printedLengths(found, "length").keys()]).toEqual(["value", "min", "max"]);
  expect([...printedLengths(found, "angle").keys()]).toEqual([]);
});

test("a word of an approach is shown in the unit of the program, its angle in degrees", () => {
  const len = issue("outOfRange", "error", { value: -25.4, min: 0, max: 2540, nearest: 25.4 }, "LEN");
  expect(message(inch, len)).toBe("-1 is out of range: 0 to 100. Proposed: 1.");
  const angle = issue("outOfRange", "error", { value: 400, min: 1, max: 360, nearest: 360 }, "CCA");
  expect(message(inch, angle)).toContain("360°");
});
