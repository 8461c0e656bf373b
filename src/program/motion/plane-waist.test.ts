import { describe, expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { run } from "../run/run.ts";

/** A milling program with tool radius 5 round some lines, the tool at Z+20. */
const milled = (lines: string) =>
  run(
    parse(
      `BEGIN PGM T MM\nTOOL DEF 1 L+0 R+5\nTOOL CALL 1 Z S4000\nL Z+20 R0 FMAX\n${lines}\nL Z+20 R0 FMAX M2\nEND PGM T MM\n`,
    ),
    {
      tools: [],
      rapid: 10_000,
    },
  );
const faults = (lines: string) =>
  milled(lines)
    .issues.filter((f) => f.issue.severity !== "info")
    .map((f) => f.issue.code);
const blank = "BLK FORM 0.1 Z X-50 Y-50 Z-20\nBLK FORM 0.2 X+50 Y+50 Z+0\n";
/** A mouth of 9 mm in front of a pocket of 21. */
const POCKET = "L X+0 Y+0\nL X+10\nL Y-6\nL X+40\nL Y+15\nL X+10\nL Y+9\nL X+0\nL X-30 Y+19";
const approached = (side: string) =>
  `L X-40 Y-40 R0 F500\nAPPR LT X-30 Y-10 LEN10 ${side} F100\n${POCKET}\nDEP LT LEN10`;
const onLine = (...lines: readonly string[]) => `L X-40 Y-40 R0 F500\n${lines.join("\n")}\nL X-60 Y-60 R0`;
const OVER = ["L X+40", "L Y-20", "L X+60", "L Y+8", "L X+0"];

describe("a contour that a tool cuts away from where it mills", () => {
  test.each([
    ["a mouth narrower than the tool", approached("RL"), ["pathCutsContour"]],
    ["the same mouth from outside", approached("RR"), []],
    [
      "elements drawn beyond their corner into the air",
      onLine("L X-20 Y+0 RR F200", "L X+50", "L Y+50", "L X+0", "L Y-20"),
      [],
    ],
    ["a pocket all in its blank", `${blank}L Z-1\n${onLine("L X-30 Y-10 RL F100", POCKET)}`, ["pathCutsContour"]],
    ["the same above the blank", `${blank}L Z+1\n${onLine("L X-30 Y-10 RL F100", POCKET)}`, []],
    ["a way back beside itself", `${blank}L Z-1\n${onLine("L X+0 Y+0 RL F100", ...OVER)}`, ["pathCutsContour"]],
    [
      "a way back above the blank",
      `${blank}L Z-1\n${onLine("L X+0 Y+0 RL F100", "L X+40", "L Z+2", ...OVER.slice(1))}`,
      [],
    ],
  ])("%s", (_, lines, codes) => expect(faults(lines)).toEqual(codes));

  test("is named by element, place and depth, with the radius that passes", () => {
    const found = milled(approached("RL")).issues.find((f) => f.issue.code === "pathCutsContour");
    expect(found?.issue.data).toMatchObject({ element: 1, other: 8, depth: 1, y: 9, nearest: 4.5 });
  });

  test("a tool that does not fit its neighbours is reported at its point in the plane", () => {
    const found = milled("L X-40 Y-40 R0 F500\nAPPR LT X+0 Y+0 LEN10 RR F100\nL Y+50\nRND R4\nL X+50\nL X+90 Y-90 R0")
      .issues[0]?.issue;
    const middle = 4 * (1 - Math.SQRT1_2);
    expect(found?.code).toBe("toolRadiusTooLarge");
    const { x, y } = (found?.data ?? {}) as { x: number; y: number };
    expect(x).toBeCloseTo(middle, 9);
    expect(y).toBeCloseTo(50 - middle, 9);
  });
});
