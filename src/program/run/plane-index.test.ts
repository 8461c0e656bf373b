import { readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { blockNumbers, print, startLines } from "../../nc/program.ts";
import { blockSpan } from "./block-span.ts";
import { choiceOfMilled, crossing, milledBy, momentOn, planeBegin, sideOfChoice } from "./plane-index.ts";
import { run } from "./run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";

function made(text: string) {
  const program = parse(text),
    result = run(program, { tools: shippedTools, rapid: 10_000 });
  const numbers = blockNumbers(program),
    lines = startLines(program);
  const choice = (number: number) => {
    const index = numbers.indexOf(number);
    return { kind: "blocks", span: blockSpan(program, index), line: lines[index] ?? 0 } as const;
  };
  return { program, run: result, choice };
}

const plate = made(readFileSync(new URL("../../examples/plate.h", import.meta.url), "utf8"));

test("a milled block marks its motions, and one without any leads to the next that moves", () => {
  const { run: result, choice } = plate;
  const [lead] = milledBy(result, choice(9).span);
  expect(result.plane.slice(lead?.first, (lead?.last ?? 0) + 1).map(({ block }) => block)).toEqual([9, 9]);
  expect(choiceOfMilled(result, lead?.first ?? -1)).toMatchObject({ span: { from: 9, to: 9 } });
  expect(milledBy(result, choice(4).span).at(0)?.first).toBe(0);
  expect(milledBy(result, choice(4).span).at(-1)?.last).toBe(result.plane.findLastIndex(({ block }) => block < 20));
  expect(planeBegin(result, 0)).toBe(0);
  expect(planeBegin(result, (result.plane.at(-1)?.index ?? 0) + 1)).toBeNull();
  expect(sideOfChoice(result, choice(9))).toBeNull();
});

const mixed = made(`0 BEGIN PGM MIXED MM
1 BLK FORM CYLINDER Z D62.4 L70.3
2 FUNCTION MODE TURN
3 TOOL CALL 1
4 FUNCTION TURNDATA SPIN VCONST:OFF S700
5 M136
6 L X+66.2 Z+3 R0 FMAX
7 L X+58.6 FMAX
8 L Z-20.7 F0.21
9 FUNCTION MODE MILL
10 TOOL DEF 21 L+0 R+4.2
11 TOOL CALL 21 Z S3000
12 L X-41 Y+7.3 R0 FMAX
13 L Z-3.1 R0 FMAX
14 L X+41 F400
15 FUNCTION MODE TURN
16 TOOL CALL 1
17 L X+66.2 Z+3 R0 FMAX
18 L X+55.1 FMAX
19 M30
20 END PGM MIXED MM
`);

describe("a program that turns and mills", () => {
  const { run: result, choice } = mixed;
  const turnedFirst = result.steps.findIndex(({ block }) => block > 15);
  test("has no unknown tool in a mill that TOOL DEF gives its radius; turning with it is one", () => {
    const codes = (text: string) =>
      run(parse(text), { tools: shippedTools, rapid: 10_000 }).issues.map(({ issue: { code } }) => code);
    const known = print(mixed.program);
    expect(codes(known)).not.toContain("toolUnknown");
    expect(codes(known.replace("16 TOOL CALL 1\n", "16 ;\n"))).toContain("toolUnknown");
    expect(codes(known.replace("TOOL DEF 21 L+0 R+4.2", "; 21"))).toContain("toolUnknown");
  });
  test("shows a chosen block where it moves, or where the next one does", () => {
    const sides = [7, 14, 17, 1, 10, 15].map((number) => sideOfChoice(result, choice(number)));
    expect(sides).toEqual(["lathe", "plane", "lathe", "lathe", "plane", "lathe"]);
    expect(sideOfChoice(result, { kind: "pass", operation: 0 })).toBe("lathe");
    // A tool call represents all blocks up to the next one.
    expect([3, 11].map((number) => sideOfChoice(result, choice(number)))).toEqual(["lathe", "plane"]);
  });
  test("stands at the same moment on both sides", () => {
    expect(turnedFirst).toBeGreaterThan(0);
    expect(momentOn(result, "plane", 0)).toBe(0);
    expect(momentOn(result, "plane", turnedFirst)).toBe(result.plane.length);
    expect(momentOn(result, "lathe", 1)).toBe(turnedFirst);
    expect(momentOn(result, "lathe", result.plane.length)).toBe(result.steps.length);
  });
  test("goes over to the other side where its next move is", () => {
    expect(crossing(result, "lathe", turnedFirst - 1, turnedFirst)).toBe(0);
    expect(crossing(result, "lathe", turnedFirst, turnedFirst + 1)).toBeNull();
    expect(crossing(result, "lathe", 0, 1)).toBeNull();
    expect(crossing(result, "plane", result.plane.length - 1, result.plane.length)).toBe(turnedFirst);
    expect(crossing(result, "plane", 0, 1)).toBeNull();
    expect(crossing(plate.run, "plane", plate.run.plane.length - 1, plate.run.plane.length)).toBeNull();
  });
});
