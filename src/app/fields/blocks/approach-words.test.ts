import { expect, test } from "vitest";
import { approach } from "../../../i18n/en/workplace/approach.ts";
import { approachWords } from "./approach-words.ts";

test.each([
  ["X", false, "XY", "X of the first contour point PA?"],
  ["Y", true, "XY", "Y of the end point PN?"],
  ["Z", false, "ZX", "Z of the first contour point PA?"],
  ["Z", true, "XY", "Depth or height in the tool axis?"],
] as const)("%s, departing %s, in %s: %s", (word, departing, plane, prompt) => {
  expect(approachWords(approach, word, { departing, plane }).prompt).toBe(prompt);
});
