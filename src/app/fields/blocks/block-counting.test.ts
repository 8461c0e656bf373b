import { expect, test } from "vitest";
import { parse } from "../../../nc/parse.ts";
import { print } from "../../../nc/program.ts";
import { run } from "../../../program/run/run.ts";
import { shippedTools } from "../../../program/tools/shipped-tools.ts";
import { inBlockUnits } from "../../../view/measure/distance.ts";
import { countingOf } from "./block-counting.ts";
import { withPrompt } from "./block-prompts.ts";

const CYCLE = [
  "CYCL DEF 811 SHOULDER",
  "Q215=+0",
  "Q460=+0.1",
  "Q493=+2.1",
  "Q494=-1.3",
  "Q463=+0.1",
  "Q478=+0.01",
  "Q483=+0.01",
  "Q484=+0.01",
  "Q505=+0.01",
  "Q506=+0",
].join(" ~\n");
const made = (unit: string, shift: string) => {
  const program = parse(
    `BEGIN PGM U ${unit}\nBLK FORM CYLINDER Z D3 L4\nFUNCTION MODE TURN\nTOOL CALL 1\nFUNCTION TURNDATA SPIN VCONST:OFF S700\nM136\n` +
      `${shift}\n${CYCLE}\nL X+3.3 Z+0.2 R0 FMAX M99\nM30\nEND PGM U ${unit}\n`,
  );
  const index = program.blocks.findIndex(({ statement }) => statement.kind === "cycle");
  return { ...countingOf(program, index, run(program, { tools: shippedTools, rapid: 9_000 }), null), program, index };
};

test("a block of an inch program takes inches, with one decimal more", () => {
  const inch = made("INCH", ";");
  expect(inBlockUnits("diameter", 60.334, inch)).toBe(2.3754);
  expect(inBlockUnits("axial", -33.02, inch)).toBe(-1.3);
  expect(print(withPrompt(inch.program, inch.index, "Q493", "2.3754"))).toContain("Q493=+2.3754 ~");
  const { program, index } = made("MM", ";");
  expect(print(withPrompt(program, index, "Q493", "2.3754"))).toContain("Q493=+2.375 ~");
  expect(inBlockUnits("length", 1.905, inch)).toBe(0.075);
  expect(inBlockUnits("angle", 12.3457, inch)).toBe(12.3457);
  expect(inBlockUnits("diameter", 60.334, made("MM", ";"))).toBe(60.334);
});

test("positions refer to the datum active at the call, sizes do not", () => {
  const shifted = made("MM", "TRANS DATUM AXIS X+4.2 Z-7.3");
  expect(inBlockUnits("axial", -20.02, shifted)).toBe(-12.72);
  expect(inBlockUnits("diameter", 60.334, shifted)).toBe(56.134);
  expect(inBlockUnits("axialDepth", -20.02, shifted)).toBe(-20.02);
  expect(inBlockUnits("axial", -20.02, made("INCH", "TRANS DATUM AXIS Z-0.5"))).toBe(-0.2882);
});
