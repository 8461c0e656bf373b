import { expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";

const shop = { tools: shippedTools, rapid: 10_000 };
const told = (tool: number, ...blocks: string[]) => {
  const frame = [
    "BEGIN PGM T MM",
    "BLK FORM CYLINDER Z D50 L60 DIST+0",
    "FUNCTION MODE TURN",
    `TOOL CALL ${tool}`,
    "FUNCTION TURNDATA SPIN VCONST:OFF S900",
    "M136",
  ];
  const { issues } = run(parse([...frame, ...blocks, "M30", "END PGM T MM"].join("\n")), shop);
  return issues
    .filter(({ issue }) => issue.code === "compensationUndefined")
    .map(({ issue, line }) => ({ ...issue.data, line }));
};
const START = "L X+43.6 Z+2.4 R0 FMAX M3";
const CONTOUR = ["L X+31.3 Z+0 RR F0.2", "L Z-12.7", "L X+47 Z-19.1", "L X+60 R0 FMAX"];

// In the shipped table, 2, 4, 6 and 8 point along one axis, 1, 3, 7 into a corner; 11 is round with its tip at the
// bottom.
test.each([
  [1, []],
  [7, []],
  [5, []],
  [11, [{ side: "RR", orientation: 2, line: 8 }]],
  [9, [{ side: "RR", orientation: 2, line: 8 }]],
  [
    14,
    [
      {
        side: "RR",
        orientation: 6,
        line: 8,
      },
    ],
  ],
  [8, [{ side: "RR", orientation: 8, line: 8 }]],
])("tool %i: RR with a neutral tip is reported once, where it begins", (tool, expected) => {
  expect(told(tool, START, ...CONTOUR)).toEqual(expected);
});

test("an approach begins it as well, R0 does not, and each beginning is reported", () => {
  expect(told(9, START, "APPR LT X+31.3 Z-1.2 LEN3 RL F0.2", "L Z-12.7", "DEP LT LEN2 F0.3")).toEqual([
    {
      side: "RL",
      orientation: 2,
      line: 8,
    },
  ]);
  expect(told(9, START, "L X+31.3 Z+0 R0 F0.2", "L Z-12.7")).toEqual([]);
  expect(told(9, START, ...CONTOUR, START, ...CONTOUR).map(({ line }) => line)).toEqual([8, 13]);
});
