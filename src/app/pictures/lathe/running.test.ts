import { expect, test } from "vitest";
import { lengthsIn } from "../../../i18n/lengths.ts";
import { texts } from "../../../i18n/index.ts";
import { parse } from "../../../nc/parse.ts";
import { run } from "../../../program/run/run.ts";
import { shippedTools } from "../../../program/tools/shipped-tools.ts";
import { runningText } from "./running.ts";

/** The speeds at the ends of two L blocks after the start: after a speed block, and after another. */
function speedsOf(spin: string, most?: number) {
  const text = [
    "BEGIN PGM T MM",
    "BLK FORM CYLINDER Z D90 L80 DIST+0",
    "FUNCTION MODE TURN",
    "TOOL CALL 1",
    spin,
    "M136",
    "L X+80 Z+2 R0 FMAX M3",
    "L Z-20 F0.2",
    "FUNCTION TURNDATA SPIN VCONST:OFF S700",
    "L X+95",
    "M30",
    "END PGM T MM",
  ];
  const machine = most === undefined ? {} : { machine: { name: "M", spindle: { most } } };
  const made = run(parse(text.join("\n")), { tools: shippedTools, rapid: 10_000, ...machine });
  return made.steps.map(
    (_, step) =>
      runningText(texts("en"), lengthsIn("en", "mm", 1), made, { step, fraction: 1 })?.speed.replace(/\D/g, "") ?? "",
  );
}

// VC 150 m/min at ⌀80: 150000 / (80 π) = 597; limits of the block and of the machine are lower.
test.each([
  ["FUNCTION TURNDATA SPIN VCONST:ON VC:150", undefined, ["597", "700"]],
  ["FUNCTION TURNDATA SPIN VCONST:ON VC:150 SMAX500", undefined, ["500", "700"]],
  ["FUNCTION TURNDATA SPIN VCONST:ON VC:150", 450, ["450", "450"]],
  ["FUNCTION TURNDATA SPIN VCONST:OFF S900", undefined, ["900", "700"]],
  ["M140", undefined, ["", "700"]],
])("L blocks show the speed they run at: %s, most %s", (spin, most, speeds) =>
  expect(speedsOf(spin, most)).toEqual(speeds),
);
