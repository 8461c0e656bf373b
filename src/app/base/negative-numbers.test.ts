import { expect, test } from "vitest";
import { splitNegativeNumbers } from "./negative-numbers.ts";

test("a negative number stays together with its axis and its point, in any context", () => {
  expect(splitNegativeNumbers("von Z-20,5 bis X-1.6, dann")).toEqual(["von ", "Z-20,5", " bis ", "X-1.6,", " dann"]);
  expect(splitNegativeNumbers("Q482=-38 (DIST-20)")).toEqual(["", "Q482=-38", " (", "DIST-20", ")"]);
});

test("in Chinese, text follows without a space: a line may break there", () => {
  expect(splitNegativeNumbers("图中标的是刀尖，Z-0.4。手册印的是铣削")).toEqual([
    "图中标的是刀尖，",
    "Z-0.4",
    "。手册印的是铣削",
  ]);
});

test("a hyphen in a word is no minus", () => {
  expect(splitNegativeNumbers("80-%-Regel, set-up")).toEqual(["80-%-Regel, set-up"]);
});
