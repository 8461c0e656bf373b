import { describe, expect, test } from "vitest";
import { at } from "../kernel/geometry/point.ts";
import { shippedTools } from "../program/tools/shipped-tools.ts";
import { labelsOverlap, type LabelBox } from "./dimensions/labels.ts";
import { namedLines, toolArea, type NamedLine } from "./known-labels.ts";

const ROOM: LabelBox = { x: 46, y: 44, width: 613, height: 371 };
const level = (text: string, at: number): NamedLine => ({ text, way: "level", at });
const upright = (text: string, at: number): NamedLine => ({ text, way: "upright", at });
const inside = (b: LabelBox) =>
  b.x >= ROOM.x && b.y >= ROOM.y && b.x + b.width <= ROOM.x + ROOM.width && b.y + b.height <= ROOM.y + ROOM.height;

describe("texts of lines across the picture", () => {
  test.each<[string, readonly NamedLine[], readonly LabelBox[]]>([
    ["far apart", [level("Q491 ⌀61.37", 120), upright("Q492 Z-3.5", 300)], []],
    ["at one place", [level("Q491 ⌀61.37", 120), level("Q493 ⌀61.41", 121), upright("Q492 Z0", 640)], []],
    ["at the edges", [upright("Q492 Z-40.25", 47), upright("Q494 Z0.5", 658), level("Q491 ⌀90", 45)], []],
    [
      "behind a tool",
      [upright("Q492 Z-3.5", 300), upright("Q494 Z-9.5", 330)],
      [{ x: 240, y: 0, width: 160, height: 300 }],
    ],
    ["beside a text", [level("Q493 ⌀61.37", 120)], [{ x: 560, y: 90, width: 99, height: 60 }]],
  ])("%s: in the picture, clear of each other and of what is kept", (_, lines, kept) => {
    const placed = namedLines(lines, ROOM, kept);
    expect(placed).toHaveLength(lines.length);
    placed.forEach((box, i) => {
      expect(inside(box), JSON.stringify(box)).toBe(true);
      for (const other of [...placed.slice(i + 1), ...kept]) expect(labelsOverlap(box, other)).toBe(false);
    });
  });

  test("stand beside their line, at the right edge and at the top", () => {
    const [x, z] = namedLines([level("Q491 ⌀61.37", 120), upright("Q492 Z-3.5", 300)], ROOM, []);
    expect(120 - ((x?.y ?? 0) + (x?.height ?? 0))).toBe(4);
    expect(ROOM.x + ROOM.width - ((x?.x ?? 0) + (x?.width ?? 0))).toBe(8);
    expect([z?.x, z?.y]).toEqual([304, 44]);
  });
});

test("the box of a tool holds its holder, wherever its tip is and whichever way X points", () => {
  const tool = shippedTools.find((each) => each.holder) ?? expect.fail("a tool has a holder");
  const camera = { scale: 3, zero: { x: 400, y: 210 }, xUp: true };
  const up = toolArea(tool, at(10, 20), camera) ?? expect.fail("it has a shape"),
    down = toolArea(tool, at(10, 20), { ...camera, xUp: false }) ?? expect.fail("it has a shape");
  expect(up.height).toBeGreaterThan(3 * 20);
  expect(down.x).toBe(up.x);
  expect(down.y).toBeCloseTo(2 * 210 - up.y - up.height, 6);
});
