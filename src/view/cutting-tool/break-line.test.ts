import { expect, test } from "vitest";
import { at } from "../../kernel/geometry/point.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import type { Camera } from "../camera.ts";
import { breakData, breakOf } from "./break-line.ts";

const tool = (T: number) => shippedTools.find((each) => each.T === T) as Tool;
const camera: Camera = { scale: 3.7, zero: { x: 300, y: 350 }, xUp: true };
const seen = { left: 60, right: 620, top: 14, bottom: 380 };

test("a shank along X is cut off at the upper edge, and at the lower one with X down", () => {
  // Shank 25 × 114, from 7 mm beside and 28 mm above the tip.
  const found = breakOf(tool(1), at(-10.3, 30.1), camera, seen);
  expect(found?.turn).toBe(270);
  expect(found?.width).toBeCloseTo(25 * 3.7, 9);
  expect(found?.at.y).toBe(14);
  const [left, right] = [300 + (-10.3 + 7) * 3.7, 300 + (-10.3 + 32) * 3.7];
  expect(found?.at.x).toBeCloseTo((left + right) / 2, 9);
  expect(breakOf(tool(1), at(-10.3, 30.1), { ...camera, xUp: false, zero: { x: 300, y: 100 } }, seen)?.turn).toBe(90);
});

test("a boring bar is cut off at the right edge", () => {
  const found = breakOf(tool(5), at(-20.7, 15.3), camera, seen);
  expect(found?.turn).toBe(0);
  expect(found?.at.x).toBe(620);
  expect(found?.width).toBeCloseTo(20 * 3.7, 9);
});

test("no break if the end of the shank is visible, the tool is out of the picture, or it has no holder", () => {
  const far = { ...camera, scale: 0.9 };
  expect(breakOf(tool(1), at(-10.3, 30.1), far, seen)).toBeNull();
  expect(breakOf(tool(1), at(900, 30.1), camera, seen)).toBeNull();
  expect(breakOf(tool(1), at(-10.3, 330), camera, seen)).toBeNull();
  const { holder: _, ...bare } = tool(1);
  expect(breakOf(bare, at(-10.3, 30.1), camera, seen)).toBeNull();
});

test("the line goes across the shank and the ground behind it to the edge", () => {
  const { line, ground } = breakData(74, 21);
  expect(line.startsWith("M0 -40C")).toBe(true);
  expect(line.endsWith(" 0 40")).toBe(true);
  expect(ground).toBe(`${line}H21V-40Z`);
});
