import { describe, expect, test } from "vitest";
import { parse } from "../../../nc/parse.ts";
import { withBlock } from "../../../nc/edit.ts";
import { approachContext } from "../../../program/edits/approach-context.ts";
import { run } from "../../../program/run/run.ts";
import { shippedTools } from "../../../program/tools/shipped-tools.ts";
import { suggestedForms } from "../../../view/approach/forms.ts";
import { withForm } from "./change-form.ts";

const MILLED = (block: string, pole = "CC X+0 Y+0") => `BEGIN PGM M MM
TOOL DEF 1 L+0 R+10
TOOL CALL 1 Z S4000
L X-10 Y-10 R0 FMAX
${pole}
${block.startsWith("DEP") ? "APPR LT X+5 Y+5 LEN10 RL F300" : block}
L Y+95
L X+95
${block.startsWith("DEP") ? block : "DEP LT LEN10"}
END PGM M MM
`;
const TURNED = (block: string) => `BEGIN PGM T MM
BLK FORM CYLINDER Z D60 L70 DIST+1
FUNCTION MODE TURN
TOOL CALL 3
FUNCTION TURNDATA SPIN VCONST:ON VC:180 SMAX2500 M3
M136
L X+80 Z+5 R0 FMAX
CC X+0 Z+0
${block}
L X+40 Z-5
L Z-30
L X+62
END PGM T MM
`;

/** The block with another form, as its line of the program. */
function changed(text: string, block: string, shape: string, departing: boolean, polar: boolean): string {
  const program = parse(text);
  const index = program.blocks.findIndex(({ raw }) => raw.trim() === block);
  const statement = program.blocks[index]?.statement;
  if (statement?.kind !== "approach") throw new Error(`${block} is no approach`);
  const context = approachContext(program, index, run(program, { tools: shippedTools, rapid: 10_000 }), {});
  const { contour, side, toolRadius, before } = context;
  const taken = suggestedForms({ contour, side, toolRadius, outside: before }, departing).find(
    (form) => form.shape === shape,
  );
  if (!taken) throw new Error(`no ${shape}`);
  return withBlock(program, index, withForm(statement, taken, context, polar)).blocks[index]?.raw.trim() ?? "";
}

describe("the point stays where it is when its coordinates change", () => {
  test.each([
    ["APPR LT X+0 Y+5 LEN10 RL F300", "LT", "APPR PLT PR+5 PA+90 LEN10 RL F300"],
    ["APPR LT X+0 Y+5 LEN10 RL F300", "CT", "APPR PCT PR+5 PA+90 CCA90 R+10 RL F300"],
    ["APPR PLT PR+5 PA+90 LEN10 RL F300", "LN", "APPR PLN PR+5 PA+90 LEN+10 RL F300"],
    ["DEP LCT X+100 Y+0 R5 F1000", "LCT", "DEP PLCT PR+100 PA+0 R5 F1000"],
  ])("milled, polar: %s → %s", (block, shape, expected) => {
    expect(changed(MILLED(block), block, shape, block.startsWith("DEP"), true)).toBe(expected);
  });
  test("milled, Cartesian again", () => {
    const block = "APPR PLT PR+5 PA+90 LEN10 RL F300";
    expect(changed(MILLED(block), block, "LT", false, false)).toBe("APPR LT X+0 Y+5 LEN10 RL F300");
  });
  test("turned: X is a diameter, PR and PA are measured in Z/X", () => {
    const block = "APPR LT X+30 Z+0 LEN5 RR F0.2";
    expect(changed(TURNED(block), block, "LT", false, true)).toBe("APPR PLT PR+15 PA+90 LEN5 RR F0.2");
  });
});

test("a departure that names no point has no polar form", () => {
  const block = "DEP LT LEN10";
  expect(changed(MILLED(block), block, "LN", true, true)).toBe("DEP LN LEN+10");
});

test.each([
  [MILLED("APPR LT X+0 Y+5 LEN10 RL F300"), "APPR LT X+0 Y+5 LEN10 RL F300"],
  [TURNED("APPR LT X+30 Z+0 LEN10 RR F300"), "APPR LT X+30 Z+0 LEN10 RR F300"],
])("an approach that becomes a departure drops its point", (text, block) => {
  expect(changed(text, block, "LT", true, false)).toBe("DEP LT LEN10 F300");
});

test("a departure that no longer names its point drops it", () => {
  const block = "DEP LCT X+100 Y+0 R5 F1000";
  expect(changed(MILLED(block), block, "CT", true, false)).toBe("DEP CT CCA90 R+5 F1000");
});

test("without a pole every form is Cartesian", () => {
  const block = "APPR LT X+0 Y+5 LEN10 RL F300";
  expect(changed(MILLED(block, "L Z-5"), block, "LT", false, true)).toBe(block);
});
