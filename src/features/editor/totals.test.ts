import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { run } from "../../program/run/run.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { operationCount } from "./TotalsStrip.tsx";

const turned = readFileSync("tests/programs/shoulder-812.h", "utf8");
const milled = [
  "FUNCTION MODE MILL",
  "TOOL CALL 20 Z S3000",
  "L Z+50 R0 FMAX M3",
  "L X-60 Y-40 FMAX",
  "L Z-5 F800",
  "APPR LCT X-30 Y-20 R5 RL F300",
  "L Y+20",
  "L X+30",
  "DEP LCT X-60 Y-40 R5",
  "L Z+50 FMAX M5",
];

/** Counts the operations of a turned shoulder with blocks before its end. */
function counted(more: readonly string[]): number {
  const lines = turned.replaceAll(/^\d+ /gm, "").split(/\r?\n/),
    end = lines.findIndex((line) => /^M30\b|\bM30$/.test(line));
  const program = parse([...lines.slice(0, end), ...more, ...lines.slice(end)].join("\n"));
  return operationCount(program, run(program, { tools: shippedTools, rapid: 10_000 }));
}

test("operations without a turning cycle are counted as in the list of operations, a skipped one is not", () => {
  const byHand = ["TOOL CALL 9", "L X+60 Z-20 R0 FMAX", "L X+30 F0.06", "L X+60 FMAX"];
  expect([counted(byHand), counted(byHand.map((block) => `/ ${block}`))]).toEqual([2, 1]);
});

test("milling operations are counted as in the list of operations", () => {
  expect([counted([]), counted(milled), counted([...milled, ...milled.with(1, "TOOL CALL 21 Z S2500")])]).toEqual([
    1, 2, 3,
  ]);
});
