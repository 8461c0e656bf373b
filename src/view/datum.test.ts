import { expect, test } from "vitest";
import { parse } from "../nc/parse.ts";
import { run } from "../program/run/run.ts";
import { shippedTools } from "../program/tools/shipped-tools.ts";
import { datumAt, datumIndex } from "./datum.ts";

const turned = (lines: string) =>
  run(
    parse(
      `BEGIN PGM T MM\nFUNCTION MODE TURN\nTOOL CALL 1\nL X+100 Z+50 FMAX\nL Z+40 FMAX\n${lines}\nM30\nEND PGM T MM\n`,
    ),
    {
      tools: shippedTools,
      rapid: 10_000,
    },
  );
const shown = (lines: string) => {
  const { datums, steps } = turned(lines);
  return Array.from({ length: steps.length + 1 }, (_, step) => {
    const { z, r } = datumAt(datums, datumIndex(datums, step));
    return [r, z];
  });
};

test("the mark shows the datum of each step, and at the end the last datum", () => {
  expect(
    shown("TRANS DATUM AXIS X+4 Z-12.5\nL Z+30 FMAX\nTRANS DATUM RESET\nL Z+5 FMAX\nTRANS DATUM AXIS Z+3"),
  ).toEqual([
    [0, 0],
    [2, -12.5],
    [0, 0],
    [0, 3],
  ]);
});

test("a program that never moves with a shifted datum has no datum marks", () => {
  expect(turned("L Z+3 FMAX").datums).toEqual([]);
  expect(turned("TRANS DATUM AXIS Z-9\nTRANS DATUM RESET\nL Z+3 FMAX").datums).toEqual([]);
});
